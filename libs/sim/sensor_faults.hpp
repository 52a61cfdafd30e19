// Sensors that fail: what the simulated robot observes -> what its broken sensors say.
// Faults overlap; each lasts from when it began until its time is over. Stamps stay those of the measurements, but for
// a stuck sensor, which says its last measurement again as if it were new. Odometry that is stuck or wrong loses or
// adds motion for good; where it was off it knows afterwards how far the robot has come. Frames carry the faulty
// odometry of their instant.
#pragma once

#include <deque>
#include <map>
#include <vector>

#include "core/random.hpp"
#include "robot/robot.hpp"
#include "world/script.hpp"

namespace amiss::sim {

class SensorFaults {
 public:
  explicit SensorFaults(std::uint64_t seed) : random_(seed, "sensor_faults") {}

  /// ArgumentError for a jump of anything but odometry.
  void begin(const world::Fault& fault, Stamp now);
  void apply(robot::Observation& seen);

 private:
  struct Active {
    world::Fault fault;
    Stamp began, ends;
  };
  [[nodiscard]] bool fails(world::Sensor sensor, world::FaultKind kind, Stamp now, double* amount = nullptr) const;
  /// Does the sensor say nothing at this instant: off, or in the second half of an intermittent period?
  [[nodiscard]] bool is_silent(world::Sensor sensor, Stamp now) const;
  void apply_to_odometry(robot::Observation& seen);
  void apply_to_laser(robot::Observation& seen);
  void apply_to_camera(robot::Observation& seen);
  [[nodiscard]] Pose2<Odom, Base> odometry_at(Stamp stamp) const;

  RandomStream random_;
  std::vector<Active> active_;
  Pose2<Odom, Base> true_odometry_, felt_;  // as it would be, and with the motion lost and added
  std::deque<Odometry> odometry_;           // as it was felt, of the last seconds
  Odometry told_;
  std::optional<LaserScan> last_scan_;
  std::deque<std::pair<Stamp, LaserScan>> late_scans_;  // by arrival
  std::optional<Stamp> scan_told_, frame_told_;
  std::optional<robot::CapturedFrame> last_frame_;
  std::deque<std::pair<Stamp, robot::CapturedFrame>> late_frames_;
};

}  // namespace amiss::sim
