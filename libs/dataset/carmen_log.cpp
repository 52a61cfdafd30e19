#include "dataset/carmen_log.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "dataset/internal/text.hpp"

namespace amiss::dataset {
namespace {

std::string number(double value, int digits) {
  std::array<char, 64> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return {text.data(), static_cast<std::size_t>(length)};
}

template <class To, class From>
std::string pose(const Pose2<To, From>& p) {
  return number(p.x_m, 6) + " " + number(p.y_m, 6) + " " + number(p.yaw_rad, 6);
}

/// Time of the message, who logged it, and when: the end of every line.
std::string ending(Stamp stamp) { return text_of(stamp) + " amiss " + text_of(stamp) + "\n"; }

}  // namespace

void CarmenLog::add(const Odometry& odometry) {
  text_ += "ODOM " + pose(odometry.T_odom_base) + " 0 0 0 " + ending(odometry.stamp);
}

void CarmenLog::add(const LaserScan& scan, const Odometry& odometry, const Transform<Base, Laser>& T_base_laser) {
  const Eigen::Isometry3d& T = T_base_laser.T;
  const Pose2<Base, Laser> mount{T.translation().x(), T.translation().y(), std::atan2(T(1, 0), T(0, 0))};
  const double beams = static_cast<double>(scan.ranges_m.size());
  text_ += "ROBOTLASER1 0 " + number(scan.angle_min_rad, 6) + " " + number(scan.angle_step_rad * (beams - 1.0), 6) +
           " " + number(scan.angle_step_rad, 8) + " " + number(scan.max_range_m, 2) + " 0.01 0 " +
           std::to_string(scan.ranges_m.size());
  for (const float range_m : scan.ranges_m) {
    text_ += " " + number(std::isfinite(range_m) ? static_cast<double>(range_m) : scan.max_range_m, 3);
  }
  text_ += " 0 " + pose(odometry.T_odom_base * mount) + " " + pose(odometry.T_odom_base) + " 0 0 0 0 0 " +
           ending(scan.stamp);
}

}  // namespace amiss::dataset
