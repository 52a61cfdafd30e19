// What the motors make of a command within one period: limits of speed and acceleration of the base, the speed and the
// range of the head's joints. Command, time -> velocity in the base frame, joint angles.
#pragma once

#include "robot/model.hpp"

namespace amiss::sim {

class Motors {
 public:
  explicit Motors(const robot::Limits& limits) : limits_(limits) {}

  void step(const robot::Command& command, Duration dt);
  /// Something held the robot: this is how it really moved.
  void held(const Eigen::Vector2d& velocity_base_m_s, double yaw_rate_rad_s);

  [[nodiscard]] const Eigen::Vector2d& velocity_base_m_s() const { return velocity_base_m_s_; }
  [[nodiscard]] double yaw_rate_rad_s() const { return yaw_rate_rad_s_; }
  [[nodiscard]] const robot::HeadState& head() const { return head_; }
  /// The pose after `dt` at the present velocity.
  [[nodiscard]] Pose2<amiss::World, Base> advanced(const Pose2<amiss::World, Base>& pose, Duration dt) const;

 private:
  robot::Limits limits_;
  Eigen::Vector2d velocity_base_m_s_ = Eigen::Vector2d::Zero();
  double yaw_rate_rad_s_ = 0.0;
  robot::HeadState head_;
};

}  // namespace amiss::sim
