#include "mapping/seen_space.hpp"

#include "core/result.hpp"

namespace amiss::mapping {
namespace {

/// Of the factor x factor x factor fine voxels from (x, y, z) of the block on.
Occupancy together(const ValueBlock& block, int x, int y, int z, int factor) {
  const std::uint64_t row = ((std::uint64_t{1} << factor) - 1) << x;
  std::uint64_t square = 0;
  for (int i = 0; i < factor; ++i) square |= row << (kBlockEdge * (y + i));
  bool all_known = true;
  for (int i = 0; i < factor; ++i) {
    const auto layer = static_cast<std::size_t>(z + i);
    if ((block.occupied[layer] & square) != 0) return Occupancy::kOccupied;
    all_known &= (block.known[layer] & square) == square;
  }
  return all_known ? Occupancy::kFree : Occupancy::kUnknown;
}

}  // namespace

VoxelMap seen_space(const VoxelBlocks& values, double voxel_m, int factor) {
  if (factor != 1 && factor != 2 && factor != 4 && factor != 8) {
    throw ArgumentError("reconstruct.space: allowed are 1, 2, 4 and 8 voxels");
  }
  VoxelMapParams params;
  params.resolution_m = factor * voxel_m;
  VoxelMap space(params);
  const int edge = kBlockEdge / factor;
  for (const ValueBlock& block : values.blocks()) {
    for (int z = 0; z < edge; ++z) {
      for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
          const Occupancy value = together(block, x * factor, y * factor, z * factor, factor);
          if (value == Occupancy::kUnknown) continue;
          space.set({block.key.x * edge + x, block.key.y * edge + y, block.key.z * edge + z}, value);
        }
      }
    }
  }
  return space;
}

}  // namespace amiss::mapping
