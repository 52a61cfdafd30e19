// Where on the whole map a scan fits, without any prior: for a robot that was carried away.
// A distance field, places where a robot can stand, points in the base frame [m] -> poses, best first, no two near each
// other. Exhaustive over a coarse lattice of poses with a wide kernel, then the best are aligned (distance_field.hpp).
#pragma once

#include <vector>

#include "localize/internal/distance_field.hpp"

namespace amiss::localize::internal {

/// Centres of free cells on a coarse lattice that are not nearer to a wall than a robot's middle can be.
[[nodiscard]] std::vector<Eigen::Vector2d> places_to_stand(const FloorGrid& map, const DistanceField& field);

struct FittingPose {
  Pose2<Map, Base> T_map_base;
  double fit = 0.0;           // part of the points within the given distance of a wall
  double plausibility = 0.0;  // distance_field.hpp
};

/// Are these two readings of one place?
[[nodiscard]] bool is_same_place(const Pose2<Map, Base>& a, const Pose2<Map, Base>& b);

/// The most plausible first; empty where there is no place or no point.
[[nodiscard]] std::vector<FittingPose> best_on_map(const DistanceField& field,
                                                   const std::vector<Eigen::Vector2d>& places_map,
                                                   const std::vector<Eigen::Vector2d>& points_base,
                                                   const Eigen::Vector2d& laser_base, double near_m);

}  // namespace amiss::localize::internal
