// The port between what thinks and what moves: a simulated HSR stands behind it, a real one could.
// command() holds until the next one; observe() lets one control period pass and returns what arrived in it.
#pragma once

#include <optional>

#include "core/sensors.hpp"

namespace amiss::robot {

class Model;  // kinematics and limits, robot/model.hpp

/// Wanted motion; limits of speed and acceleration are applied by the robot.
struct Command {
  Eigen::Vector2d velocity_base_m_s = Eigen::Vector2d::Zero();
  double yaw_rate_rad_s = 0.0;
  double pan_rad = 0.0;  // targets of the head, reached at its own speed
  double tilt_rad = 0.0;
};

struct HeadState {
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
};

/// A frame with what the robot's own sensors said at the instant it was taken (frame.stamp; it arrives later).
struct CapturedFrame {
  RgbdFrame frame;
  Transform<Base, Camera> T_base_camera;
  Pose2<Odom, Base> T_odom_base;
};

struct Observation {
  Stamp stamp;
  Odometry odometry;
  HeadState head;
  std::optional<LaserScan> scan;
  std::optional<CapturedFrame> frame;
  bool bumper = false;  // pressed: the base cannot go on in this direction
};

class Robot {
 public:
  virtual ~Robot() = default;
  [[nodiscard]] virtual const Model& model() const = 0;
  virtual void command(const Command& command) = 0;
  virtual Observation observe() = 0;
};

}  // namespace amiss::robot
