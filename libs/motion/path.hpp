// A way for the robot's centre over the floor: corners of a polyline in the map frame and the heading at its end.
#pragma once

#include <vector>

#include "motion/drive_map.hpp"

namespace amiss::motion {

struct Path {
  std::vector<Eigen::Vector2d> points_m;  // at least one, map frame
  double final_yaw_rad = 0.0;

  [[nodiscard]] double length_m() const;
};

/// Smallest clearance along the polyline from `from_m` metres after its beginning on; places that are not free have 0.
[[nodiscard]] double min_clearance_m(const DriveMap& map, const Path& path, double from_m = 0.0);

/// Is the straight line passable for the robot's centre?
[[nodiscard]] bool straight_passable(const DriveMap& map, const Eigen::Vector2d& a_map, const Eigen::Vector2d& b_map);

}  // namespace amiss::motion
