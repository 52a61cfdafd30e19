#include "sim/motors.hpp"

#include <algorithm>

namespace amiss::sim {
namespace {

double approach(double now, double wanted, double most_change) {
  return now + std::clamp(wanted - now, -most_change, most_change);
}

Eigen::Vector2d limited(const Eigen::Vector2d& v, double most) {
  return v.norm() > most ? Eigen::Vector2d(v * (most / v.norm())) : v;
}

/// A number that is not finite is no wish: stand still.
double finite_or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

}  // namespace

void Motors::step(const robot::Command& command, Duration dt) {
  const double dt_s = seconds(dt);
  const robot::Limits& l = limits_;
  const Eigen::Vector2d asked(finite_or_zero(command.velocity_base_m_s.x()),
                              finite_or_zero(command.velocity_base_m_s.y()));
  velocity_base_m_s_ += limited(limited(asked, l.speed_m_s) - velocity_base_m_s_, l.acceleration_m_s2 * dt_s);
  const double yaw_rate = std::clamp(finite_or_zero(command.yaw_rate_rad_s), -l.yaw_rate_rad_s, l.yaw_rate_rad_s);
  yaw_rate_rad_s_ = approach(yaw_rate_rad_s_, yaw_rate, l.yaw_acceleration_rad_s2 * dt_s);
  const double pan = std::clamp(finite_or_zero(command.pan_rad), l.pan_min_rad, l.pan_max_rad);
  const double tilt = std::clamp(finite_or_zero(command.tilt_rad), l.tilt_min_rad, l.tilt_max_rad);
  head_.pan_rad = approach(head_.pan_rad, pan, l.head_rad_s * dt_s);
  head_.tilt_rad = approach(head_.tilt_rad, tilt, l.head_rad_s * dt_s);
}

void Motors::held(const Eigen::Vector2d& velocity_base_m_s, double yaw_rate_rad_s) {
  velocity_base_m_s_ = velocity_base_m_s;
  yaw_rate_rad_s_ = yaw_rate_rad_s;
}

Pose2<amiss::World, Base> Motors::advanced(const Pose2<amiss::World, Base>& pose, Duration dt) const {
  const double turn_rad = yaw_rate_rad_s_ * seconds(dt);
  const Eigen::Rotation2Dd heading(pose.yaw_rad + 0.5 * turn_rad);  // in the middle of the time
  const Eigen::Vector2d p = pose.position() + heading * velocity_base_m_s_ * seconds(dt);
  return {p.x(), p.y(), wrap_angle(pose.yaw_rad + turn_rad)};
}

}  // namespace amiss::sim
