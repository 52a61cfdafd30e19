#include "mapping/raycast.hpp"

#include "mapping/internal/traversal.hpp"

namespace amiss::mapping {

std::optional<Voxel> first_blocking(const VoxelMap& map, const Eigen::Vector3d& a_map, const Eigen::Vector3d& b_map,
                                    UnknownVoxels unknown) {
  std::optional<Voxel> blocking;
  traverse(a_map / map.resolution_m(), b_map / map.resolution_m(), [&](Voxel v) {
    const Occupancy value = map.at(v);
    const bool blocks =
        value == Occupancy::kOccupied || (value == Occupancy::kUnknown && unknown == UnknownVoxels::kBlock);
    if (blocks) blocking = v;
    return !blocks;
  });
  return blocking;
}

bool line_of_sight(const VoxelMap& map, const Eigen::Vector3d& a_map, const Eigen::Vector3d& b_map,
                   UnknownVoxels unknown) {
  return !first_blocking(map, a_map, b_map, unknown);
}

}  // namespace amiss::mapping
