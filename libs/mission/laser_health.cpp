#include "mission/laser_health.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace amiss::mission {

namespace {

constexpr double kMovedM = 0.04, kMovedRad = 0.05;  // of a robot that should see something else
constexpr double kSameRangeM = 0.3;
constexpr double kLeastCommon = 0.4;
constexpr int kGarbageScans = 5;  // in a row
constexpr Duration kMoment = std::chrono::milliseconds(350);

bool has_returns(const LaserScan& scan) {
  return std::any_of(scan.ranges_m.begin(), scan.ranges_m.end(), [](float r) { return std::isfinite(r); });
}

bool is_same(const LaserScan& a, const LaserScan& b) {
  return a.ranges_m.size() == b.ranges_m.size() &&
         std::memcmp(a.ranges_m.data(), b.ranges_m.data(), a.ranges_m.size() * sizeof(float)) == 0;
}

}  // namespace

double common_part(const LaserScan& before, const LaserScan& now, double turned_rad) {
  if (now.angle_step_rad <= 0.0) return 1.0;
  const auto shift = static_cast<std::ptrdiff_t>(std::lround(turned_rad / now.angle_step_rad));
  const auto size = static_cast<std::ptrdiff_t>(std::min(before.ranges_m.size(), now.ranges_m.size()));
  int compared = 0, common = 0;
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -shift); i < size && i + shift < size; ++i) {
    const float a = before.ranges_m[static_cast<std::size_t>(i + shift)], b = now.ranges_m[static_cast<std::size_t>(i)];
    ++compared;
    const bool both_nothing = !std::isfinite(a) && !std::isfinite(b);
    if (both_nothing || std::abs(static_cast<double>(a) - static_cast<double>(b)) < kSameRangeM) ++common;
  }
  return compared == 0 ? 1.0 : static_cast<double>(common) / compared;
}

bool LaserHealth::accept(const LaserScan& scan, const Pose2<Odom, Base>& T_odom_base) {
  if (last_ && is_same(*last_, scan) && has_returns(scan)) {
    if (!same_from_) {
      same_from_ = last_pose_;
      same_since_ = last_->stamp;
    }
    const Pose2<Base, Base> moved = same_from_->inverse() * T_odom_base;
    stuck_ = stuck_ || moved.position().norm() > kMovedM || std::abs(moved.yaw_rad) > kMovedRad;
    if (!stuck_) heard_ = scan.stamp;
    return false;
  }
  same_from_.reset();
  stuck_ = false;
  bool is_garbage = false;
  if (last_ && scan.stamp - last_->stamp <= kMoment) {
    const double turned_rad = (last_pose_.inverse() * T_odom_base).yaw_rad;
    is_garbage = common_part(*last_, scan, turned_rad) < kLeastCommon;
  }
  last_ = scan;
  last_pose_ = T_odom_base;
  if (is_garbage) {
    if (++garbage_ == 1) garbage_since_ = scan.stamp;
    return false;
  }
  garbage_ = 0;
  heard_ = scan.stamp;
  return true;
}

std::optional<Trouble> LaserHealth::trouble(Stamp now) const {
  if (stuck_) return Trouble{Sense::kLaser, Complaint::kStuck, same_since_};
  if (garbage_ >= kGarbageScans) return Trouble{Sense::kLaser, Complaint::kGarbage, garbage_since_};
  if (now - heard_ > duration_of(params_.silent_s)) return Trouble{Sense::kLaser, Complaint::kSilent, heard_};
  return std::nullopt;
}

}  // namespace amiss::mission
