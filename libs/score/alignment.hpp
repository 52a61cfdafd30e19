// How a robot's map lies in the world, and how far its poses are from the truth.
// Pairs of true and estimated poses -> T_world_map by least squares (Horn 1987; what trajectory evaluation calls SE(2)
// alignment), and errors under a given alignment. Maps have no frame of their own, so errors are told after alignment
// with the run that made the map, never with the run that is judged.
#pragma once

#include <vector>

#include "core/frames.hpp"
#include "core/stamp.hpp"

namespace amiss::score {

struct PosePair {
  Stamp stamp;
  Pose2<World, Base> T_world_base;  // truth
  Pose2<Map, Base> T_map_base;      // estimate
};

/// The planar transform that carries estimated positions onto true ones with the least squared error; with fewer than
/// two distinct places the first pair decides.
[[nodiscard]] Pose2<World, Map> align(const std::vector<PosePair>& pairs);

struct LocalizationError {
  double rmse_m = 0.0, rmse_rad = 0.0, max_m = 0.0;
  std::size_t poses = 0;
};
[[nodiscard]] LocalizationError localization_error(const std::vector<PosePair>& pairs,
                                                   const Pose2<World, Map>& T_world_map);

}  // namespace amiss::score
