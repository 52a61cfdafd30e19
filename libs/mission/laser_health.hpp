// Is the laser to be believed? Scans with the odometry of their instants -> which of them to use, and what is wrong.
// A scan that repeats the one before to the last bit says nothing new, and a laser that does so while the robot moves
// is stuck. A scan that has next to nothing in common with the one a moment before is garbage, or the robot was carried
// away; in both cases one scan is no loss.
#pragma once

#include <optional>

#include "core/sensors.hpp"
#include "mission/trouble.hpp"

namespace amiss::mission {

class LaserHealth {
 public:
  explicit LaserHealth(const HealthParams& params) : params_(params) {}

  /// Should this scan be used? Stamps do not go back.
  bool accept(const LaserScan& scan, const Pose2<Odom, Base>& T_odom_base);
  [[nodiscard]] std::optional<Trouble> trouble(Stamp now) const;

 private:
  HealthParams params_;
  std::optional<LaserScan> last_;
  Pose2<Odom, Base> last_pose_;
  Stamp heard_;                                 // last scan that was used
  std::optional<Pose2<Odom, Base>> same_from_;  // where the robot was when scans began to repeat
  Stamp same_since_, garbage_since_;
  bool stuck_ = false;
  int garbage_ = 0;  // scans in a row
};

/// Part of the beams that met the same as those of the scan before, which turned by `turned_rad` since.
[[nodiscard]] double common_part(const LaserScan& before, const LaserScan& now, double turned_rad);

}  // namespace amiss::mission
