// What a prepared depth image says of the 512 voxels of one block, and how that is added to the block.
#pragma once

#include <Eigen/Core>

#include "mapping/surface_map.hpp"

namespace amiss::mapping {

/// Distance and weight that one frame gives to each voxel of a block, by index_in_block; weight 0: nothing.
struct BlockLook {
  float distance_m[kBlockVoxels];
  float weight[kBlockVoxels];
  std::int32_t pixel[kBlockVoxels];  // row-major, valid where the weight is not 0
};

struct SurfaceView {
  const float* fine;    // codes of level 0
  const float* coarse;  // of level `shift`, the same as `fine` for 0
  std::int32_t width, height, coarse_width, shift;
  float fx, fy, cx, cy;
  float truncation, voxel;
  float rays;  // that cross a voxel at z = 1
};

/// Centres of a block's voxels in the camera frame: first + x a + y b + z c [m].
struct VoxelLattice {
  float first[3], a[3], b[3], c[3];
};

void look_at_voxels(SurfaceView view, const VoxelLattice& lattice, BlockLook* look);

/// Is any voxel nearer to the surface than the truncation?
[[nodiscard]] bool near_surface(const BlockLook& look, float truncation);

/// Weighted mean of what was and what is seen; colours only near the surface.
void blend(const BlockLook& look, const Rgb* image, float truncation, float max_weight, SurfaceVoxels& voxels);

}  // namespace amiss::mapping
