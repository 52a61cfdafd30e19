// How far the robot has come, also where its odometry is late, slow, off, not a number, stuck or wrong: what odometry
// told and what the base was commanded -> a pose in the odometry frame for each instant of the last seconds.
// While odometry is well, that is what it says, to the last bit. What it has not told yet is bridged with the commanded
// motion. That it is stuck, or that its lengths or turns are wrong by a factor, shows against the poses that the laser
// sets right; the odometer then goes by commands, or by lengths that it has set right.
#pragma once

#include <deque>
#include <optional>

#include "mission/trouble.hpp"
#include "robot/model.hpp"
#include "robot/robot.hpp"

namespace amiss::mission {

class Odometer {
 public:
  Odometer(const robot::Limits& limits, const HealthParams& params) : limits_(limits), params_(params) {}

  /// Once in a control period, with the command that held meanwhile.
  void update(const Odometry& told, Stamp now, const robot::Command& command);
  /// After each scan: where the laser says that the robot is, and whether that may be believed.
  void compare(const Pose2<Map, Base>& T_map_base, bool believed);

  [[nodiscard]] const Pose2<Odom, Base>& pose() const { return history_.back().T_odom_base; }
  /// Nearest to what is remembered (ten seconds).
  [[nodiscard]] Pose2<Odom, Base> at(Stamp stamp) const;
  /// Of a measurement that came with odometry of its own.
  [[nodiscard]] Pose2<Odom, Base> at(Stamp stamp, const Pose2<Odom, Base>& told) const;
  /// Nothing to go by for too long.
  [[nodiscard]] std::optional<Trouble> trouble(Stamp now) const;

  [[nodiscard]] bool by_commands() const { return by_commands_; }
  [[nodiscard]] double length_factor() const { return length_factor_; }  // by which told lengths are too long
  [[nodiscard]] double turn_factor() const { return turn_factor_; }

 private:
  struct Regression {
    double squares = 0.0, products = 0.0, sum = 0.0;
    void add(double told, double seen);
    /// Told over seen, once there was enough of it.
    [[nodiscard]] std::optional<double> factor(double enough) const;
  };
  [[nodiscard]] bool is_credible(const Odometry& told) const;
  void drive(const robot::Command& command, double dt_s);
  [[nodiscard]] Pose2<Base, Base> commanded_since(Stamp stamp) const;
  void believe(const Odometry& told);
  void watch_factors(const Pose2<Base, Base>& told, const Pose2<Base, Base>& seen);

  robot::Limits limits_;
  HealthParams params_;
  std::deque<Odometry> history_;  // as believed, a pose for each control period

  // The base as commanded.
  Eigen::Vector2d velocity_base_m_s_ = Eigen::Vector2d::Zero();
  double yaw_rate_rad_s_ = 0.0;
  Pose2<Odom, Base> commanded_;
  std::deque<Odometry> commanded_history_;

  std::optional<Odometry> last_told_;  // finite, believed or not
  std::optional<Odometry> told_;       // believed
  Pose2<Odom, Base> believed_at_told_;
  bool plain_ = true;  // told poses are believed as they are
  bool garbage_ = false;

  std::optional<Pose2<Map, Base>> unchanged_from_;  // where the laser said to be when odometry last changed
  bool changed_ = true;
  bool by_commands_ = false;
  double length_factor_ = 1.0, turn_factor_ = 1.0;
  std::optional<Pose2<Odom, Base>> compared_at_;
  Pose2<Map, Base> compared_map_;
  Regression lengths_, turns_;
};

}  // namespace amiss::mission
