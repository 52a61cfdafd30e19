// Which space was seen empty, in voxels coarse enough for a small file: what a later visit needs to know of a map
// beside its surfaces.
//
// in: bit planes of a map with voxels of voxel_m, how many of them make an edge     out: VoxelMap of voxels with edges
// of factor * voxel_m: occupied where any of the fine voxels is, free where all are, unknown otherwise.
#pragma once

#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

/// factor: 1, 2, 4 or 8, ArgumentError for others.
[[nodiscard]] VoxelMap seen_space(const VoxelBlocks& values, double voxel_m, int factor);

}  // namespace amiss::mapping
