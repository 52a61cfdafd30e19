// The one-time mapping run that makes the reference (thesis 4.2.1), in two halves:
// 1. explore by frontiers with SLAM from laser and odometry -> FloorGrid;
// 2. localize on that grid, visit view triangles and sweep the head at each -> voxel map from RGB-D, spurious voxels
//    taken out, dilated.
#pragma once

#include <optional>

#include "mission/params.hpp"
#include "mission/reference.hpp"

namespace amiss::mission {

struct MappingReport {
  Reference reference;
  bool complete = false;  // no frontier and no view triangle was left
  int frontiers = 0, triangles = 0;
  double coverage = 0.0;  // of the reachable floor by the camera
  double distance_m = 0.0;
  Stamp ended;
};

[[nodiscard]] MappingReport make_reference(robot::Robot& robot, const Params& params, std::uint64_t seed,
                                           const Sinks& sinks);

}  // namespace amiss::mission
