// The parts of VoxelMap that read its planes only.
#include <algorithm>
#include <cmath>

#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

Voxel VoxelMap::voxel_at(const Eigen::Vector3d& p_map) const {
  const Eigen::Vector3i index = (p_map / params_.resolution_m).array().floor().cast<int>();
  return {index.x(), index.y(), index.z()};
}

Eigen::Vector3d VoxelMap::centre_of(Voxel v) const {
  return (Eigen::Vector3d(v.x, v.y, v.z) + Eigen::Vector3d::Constant(0.5)) * params_.resolution_m;
}

VoxelCounts VoxelMap::counts() const {
  VoxelCounts counts;
  for (const ValueBlock& block : values_.blocks()) {
    for (std::size_t l = 0; l < kBlockEdge; ++l) {
      counts.occupied += static_cast<std::size_t>(std::popcount(block.occupied[l]));
      counts.free += static_cast<std::size_t>(std::popcount(block.free(l)));
    }
  }
  return counts;
}

std::optional<VoxelBox> VoxelMap::bounds() const {
  std::optional<VoxelBox> box;
  for (const ValueBlock& block : values_.blocks()) {
    for_each_bit(block.key, block.known, [&box](Voxel v) {
      if (!box) box = VoxelBox{v, v};
      box->low = {std::min(box->low.x, v.x), std::min(box->low.y, v.y), std::min(box->low.z, v.z)};
      box->high = {std::max(box->high.x, v.x), std::max(box->high.y, v.y), std::max(box->high.z, v.z)};
    });
  }
  return box;
}

std::vector<Voxel> VoxelMap::voxels(Occupancy value) const {
  std::vector<Voxel> found;
  for (const ValueBlock& block : values_.blocks()) {
    BlockBits bits = block.occupied;
    for (std::size_t l = 0; l < kBlockEdge; ++l) bits[l] = value == Occupancy::kOccupied ? bits[l] : block.free(l);
    if (value != Occupancy::kUnknown) for_each_bit(block.key, bits, [&found](Voxel v) { found.push_back(v); });
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<BlockKey> VoxelMap::blocks_changed_since(std::uint64_t revision) const {
  std::vector<BlockKey> keys;
  for (const ValueBlock& block : values_.blocks()) {
    if (block.revision > revision) keys.push_back(block.key);
  }
  return keys;
}

}  // namespace amiss::mapping
