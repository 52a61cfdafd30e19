#include "mapping/internal/ray_evidence.hpp"

#include <algorithm>

#include "mapping/internal/traversal.hpp"

namespace amiss::mapping {

std::vector<BlockEvidence> ray_evidence(const Cloud<Map>& points, const Point<Map>& origin, double resolution_m) {
  VoxelBlocks touched;  // known = crossed, occupied = hit
  const Eigen::Vector3d from = origin.p / resolution_m;
  for (const Eigen::Vector3f& point : points.points) {
    if (!point.allFinite()) continue;
    const Eigen::Vector3d to = point.cast<double>() / resolution_m;
    Voxel last;
    traverse(from, to, [&](Voxel v) {
      last = v;
      if (!in_limits(v)) return false;
      touched.at_slot(touched.find_or_add(block_of(v))).known[static_cast<std::size_t>(v.z & 7)] |= std::uint64_t{1}
                                                                                                    << bit_in_layer(v);
      return true;
    });
    if (!in_limits(last)) continue;
    touched.at_slot(touched.find(block_of(last))).occupied[static_cast<std::size_t>(last.z & 7)] |=
        std::uint64_t{1} << bit_in_layer(last);
  }
  std::vector<BlockEvidence> evidence;
  evidence.reserve(touched.blocks().size());
  for (const ValueBlock& block : touched.blocks()) {
    BlockEvidence& e = evidence.emplace_back(BlockEvidence{block.key, block.occupied, {}});
    for (std::size_t l = 0; l < kBlockEdge; ++l) e.miss[l] = block.free(l);
  }
  std::sort(evidence.begin(), evidence.end(),
            [](const BlockEvidence& a, const BlockEvidence& b) { return a.key < b.key; });
  return evidence;
}

}  // namespace amiss::mapping
