// How far a round robot can go straight on before something comes nearer than its stop radius.
#pragma once

#include <span>

#include "motion/drive_map.hpp"

namespace amiss::motion::internal {

/// Hits and unit direction in the base frame. What is inside the radius already stops only motion towards it.
[[nodiscard]] double free_by_hits_m(std::span<const Eigen::Vector2d> hits_base, const Eigen::Vector2d& direction_base,
                                    double stop_radius_m, double look_m);

/// Along a straight line of the map frame, by the clearance of its cells. Where the line begins in less clearance than
/// the radius, it is free as long as the clearance does not shrink.
[[nodiscard]] double free_by_map_m(const DriveMap& map, const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map,
                                   double stop_radius_m);

/// Away from what is near on the left and on the right, 0 to 1 long each, in the base frame.
[[nodiscard]] Eigen::Vector2d away_from_sides(std::span<const Eigen::Vector2d> hits_base,
                                              const Eigen::Vector2d& direction_base, double stop_radius_m,
                                              double range_m);

}  // namespace amiss::motion::internal
