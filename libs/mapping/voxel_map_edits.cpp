#include <algorithm>

#include "mapping/plane_ops.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::mapping {
namespace {

/// The group of occupied voxels above the floor around `start`, given up once it is larger than `limit`.
std::vector<Voxel> small_group(const VoxelMap& map, Voxel start, std::size_t limit) {
  std::vector<Voxel> group{start};
  for (std::size_t next = 0; next < group.size() && group.size() <= limit; ++next) {
    for (int i = 0; i < 27; ++i) {
      const Voxel v{group[next].x + i % 3 - 1, group[next].y + i / 3 % 3 - 1, group[next].z + i / 9 - 1};
      const bool joins = v.z >= 0 && map.at(v) == Occupancy::kOccupied;
      if (joins && std::find(group.begin(), group.end(), v) == group.end()) group.push_back(v);
    }
  }
  return group;
}

VoxelMap dilated_once(const VoxelMap& map) {
  VoxelMap result = map;
  std::vector<BlockKey> keys;
  for (const ValueBlock& block : map.values().blocks()) keys.push_back(block.key);
  for (const BlockKey& key : with_neighbours(keys)) {
    if (!in_limits(voxel_in(key, 0, 0))) continue;
    BlockBits added{};
    for (std::size_t layer = 0; layer < kBlockEdge; ++layer) {
      const Neighbourhood n = occupied_around(map.values(), key, layer);
      added[layer] = grown(n) & ~n[1][1];
    }
    for_each_bit(key, added, [&result](Voxel v) { result.set(v, Occupancy::kOccupied); });
  }
  return result;
}

}  // namespace

std::vector<BlockKey> with_neighbours(const std::vector<BlockKey>& keys) {
  std::vector<BlockKey> all;
  all.reserve(9 * keys.size());
  for (const BlockKey& key : keys) {
    for (int i = 0; i < 9; ++i) all.push_back({key.x + i % 3 - 1, key.y + i / 3 - 1, key.z});
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

VoxelMap dilated(const VoxelMap& map, int radius) {
  VoxelMap result = map;
  for (int i = 0; i < radius; ++i) result = dilated_once(result);
  return result;
}

VoxelMap without_speckles(const VoxelMap& map, int max_voxels) {
  VoxelMap result = map;
  const auto limit = static_cast<std::size_t>(std::max(max_voxels, 0));
  for (const Voxel& v : map.voxels(Occupancy::kOccupied)) {
    if (v.z < 0 || small_group(map, v, limit).size() > limit) continue;
    result.set(v, Occupancy::kFree);
  }
  return result;
}

}  // namespace amiss::mapping
