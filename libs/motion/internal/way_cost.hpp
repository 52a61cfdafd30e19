// What a polyline costs: its length, each metre weighted by its clearance; and cutting corners where that is cheaper.
#pragma once

#include <vector>

#include "motion/drive_map.hpp"

namespace amiss::motion::internal {

/// Infinite where the line is not passable.
[[nodiscard]] double line_cost_m(const DriveMap& map, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                 double clearance_weight);
[[nodiscard]] double way_cost_m(const DriveMap& map, const std::vector<Eigen::Vector2d>& points,
                                double clearance_weight);

/// Corners are left out as long as the straight line costs no more than the way along them.
[[nodiscard]] std::vector<Eigen::Vector2d> shortened(const DriveMap& map, const std::vector<Eigen::Vector2d>& points,
                                                     double clearance_weight);

}  // namespace amiss::motion::internal
