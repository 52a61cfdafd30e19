#include "sim/sensor_faults.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/result.hpp"

namespace amiss::sim {

namespace {

using world::FaultKind;
using world::Sensor;

constexpr Duration kRemembered = std::chrono::seconds(10);
constexpr float kGarbageDepth_m = 8.0F;
constexpr double kGarbagePose_m = 100.0;

/// Sensor values of each kind, made garbage or wrong.
void scramble(std::vector<float>& values, double high, RandomStream& random) {
  for (float& value : values) value = static_cast<float>(random.uniform(0.0, high));
}
void scale(std::vector<float>& values, double factor) {
  for (float& value : values) value *= static_cast<float>(factor);
}

/// The first of the late ones that has arrived.
template <class Value>
std::optional<Value> arrived(std::deque<std::pair<Stamp, Value>>& late, Stamp now) {
  if (late.empty() || late.front().first > now) return std::nullopt;
  Value value = std::move(late.front().second);
  late.pop_front();
  return value;
}

}  // namespace

void SensorFaults::begin(const world::Fault& fault, Stamp now) {
  if (fault.kind == FaultKind::kJump) {
    if (fault.sensor != Sensor::kOdometry) throw ArgumentError("jump: odometry alone can jump");
    felt_ = felt_ * fault.jump;
    return;
  }
  active_.push_back({fault, now, now + duration_of(fault.for_s)});
}

bool SensorFaults::fails(Sensor sensor, FaultKind kind, Stamp now, double* amount) const {
  for (const Active& a : active_) {
    if (a.fault.sensor != sensor || a.fault.kind != kind || now < a.began || now >= a.ends) continue;
    if (amount != nullptr) *amount = a.fault.amount;
    return true;
  }
  return false;
}

bool SensorFaults::is_silent(Sensor sensor, Stamp now) const {
  return std::any_of(active_.begin(), active_.end(), [&](const Active& a) {
    if (a.fault.sensor != sensor || now < a.began || now >= a.ends) return false;
    if (a.fault.kind == FaultKind::kOff) return true;
    if (a.fault.kind != FaultKind::kIntermittent) return false;
    return std::fmod(seconds(now - a.began), 2.0 * a.fault.amount) < a.fault.amount;
  });
}

void SensorFaults::apply(robot::Observation& seen) {
  std::erase_if(active_, [&](const Active& a) { return seen.stamp >= a.ends; });
  apply_to_odometry(seen);
  apply_to_laser(seen);
  apply_to_camera(seen);
}

void SensorFaults::apply_to_odometry(robot::Observation& seen) {
  const Stamp now = seen.stamp;
  Pose2<Base, Base> motion = true_odometry_.inverse() * seen.odometry.T_odom_base;
  true_odometry_ = seen.odometry.T_odom_base;
  double amount = 0.0;
  if (fails(Sensor::kOdometry, FaultKind::kStuck, now)) motion = {};
  if (fails(Sensor::kOdometry, FaultKind::kWrong, now, &amount)) {
    motion = {amount * motion.x_m, amount * motion.y_m, amount * motion.yaw_rad};
  }
  felt_ = felt_ * motion;
  odometry_.push_back({now, felt_});
  while (odometry_.front().stamp + kRemembered < now) odometry_.pop_front();

  Odometry told{now, felt_};
  if (fails(Sensor::kOdometry, FaultKind::kDelayed, now, &amount)) {
    const Stamp then = std::max(odometry_.front().stamp, now - duration_of(amount));
    told = {then, odometry_at(then)};
  }
  const bool slow = fails(Sensor::kOdometry, FaultKind::kSlow, now, &amount) && now - told_.stamp < duration_of(amount);
  if (is_silent(Sensor::kOdometry, now) || slow) told = told_;
  if (fails(Sensor::kOdometry, FaultKind::kGarbage, now)) {
    told = {now, {random_.uniform(-kGarbagePose_m, kGarbagePose_m), std::nan(""), random_.uniform(-3.0, 3.0)}};
  } else {
    told_ = told;
  }
  seen.odometry = told;
}

Pose2<Odom, Base> SensorFaults::odometry_at(Stamp stamp) const {
  const auto after = std::upper_bound(odometry_.begin(), odometry_.end(), stamp,
                                      [](Stamp s, const Odometry& o) { return s < o.stamp; });
  return after == odometry_.begin() ? odometry_.front().T_odom_base : std::prev(after)->T_odom_base;
}

void SensorFaults::apply_to_laser(robot::Observation& seen) {
  const Stamp now = seen.stamp;
  double amount = 0.0;
  if (seen.scan && fails(Sensor::kLaser, FaultKind::kStuck, now) && last_scan_) {
    seen.scan->ranges_m = last_scan_->ranges_m;
  } else if (seen.scan) {
    last_scan_ = seen.scan;
  }
  if (seen.scan && fails(Sensor::kLaser, FaultKind::kGarbage, now)) {
    scramble(seen.scan->ranges_m, seen.scan->max_range_m, random_);
  }
  if (seen.scan && fails(Sensor::kLaser, FaultKind::kWrong, now, &amount)) scale(seen.scan->ranges_m, amount);
  if (fails(Sensor::kLaser, FaultKind::kDelayed, now, &amount) && seen.scan) {
    late_scans_.emplace_back(now + duration_of(amount), std::move(*seen.scan));
    seen.scan.reset();
  }
  if (!seen.scan) seen.scan = arrived(late_scans_, now);
  const bool slow =
      fails(Sensor::kLaser, FaultKind::kSlow, now, &amount) && scan_told_ && now - *scan_told_ < duration_of(amount);
  if (is_silent(Sensor::kLaser, now) || slow) seen.scan.reset();
  if (seen.scan) scan_told_ = now;
}

void SensorFaults::apply_to_camera(robot::Observation& seen) {
  const Stamp now = seen.stamp;
  double amount = 0.0;
  if (seen.frame) seen.frame->T_odom_base = odometry_at(seen.frame->frame.stamp);
  if (seen.frame && fails(Sensor::kCamera, FaultKind::kStuck, now) && last_frame_) {
    seen.frame->frame.colour = last_frame_->frame.colour;
    seen.frame->frame.depth_m = last_frame_->frame.depth_m;
  } else if (seen.frame) {
    last_frame_ = seen.frame;
  }
  if (seen.frame && fails(Sensor::kCamera, FaultKind::kGarbage, now)) {
    scramble(seen.frame->frame.depth_m, static_cast<double>(kGarbageDepth_m), random_);
  }
  if (seen.frame && fails(Sensor::kCamera, FaultKind::kWrong, now, &amount)) {
    scale(seen.frame->frame.depth_m, amount);
  }
  if (fails(Sensor::kCamera, FaultKind::kDelayed, now, &amount) && seen.frame) {
    late_frames_.emplace_back(now + duration_of(amount), std::move(*seen.frame));
    seen.frame.reset();
  }
  if (!seen.frame) seen.frame = arrived(late_frames_, now);
  const bool slow =
      fails(Sensor::kCamera, FaultKind::kSlow, now, &amount) && frame_told_ && now - *frame_told_ < duration_of(amount);
  if (is_silent(Sensor::kCamera, now) || slow) seen.frame.reset();
  if (seen.frame) frame_told_ = now;
}

}  // namespace amiss::sim
