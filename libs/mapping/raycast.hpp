// Is the view from a to b clear in a voxel map? (Thesis 4.2.6; traversal by Amanatides and Woo 1987.)
// in: VoxelMap, two points of the map frame     out: clear or not, and the first voxel that blocks.
#pragma once

#include <optional>

#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

enum class UnknownVoxels { kPass, kBlock };

/// The first voxel on the segment from a to b (the voxels of both ends included) that blocks, if any.
[[nodiscard]] std::optional<Voxel> first_blocking(const VoxelMap& map, const Eigen::Vector3d& a_map,
                                                  const Eigen::Vector3d& b_map, UnknownVoxels unknown);

[[nodiscard]] bool line_of_sight(const VoxelMap& map, const Eigen::Vector3d& a_map, const Eigen::Vector3d& b_map,
                                 UnknownVoxels unknown = UnknownVoxels::kPass);

}  // namespace amiss::mapping
