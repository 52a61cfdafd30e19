// OctoMap's files taken apart with distrust: every byte is accounted for before a voxel is believed.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "mapping/voxel_blocks.hpp"

namespace amiss::mapping {

struct OctreeHeader {
  bool binary = false;  // .bt
  std::size_t nodes = 0;
  double resolution_m = 0.0;
  std::size_t data_at = 0;  // first byte of the tree
};

/// The header, or InputError.
[[nodiscard]] OctreeHeader read_octree_header(std::string_view bytes, const std::string& name);

/// A cube of edge^3 equal voxels.
struct OctreeLeaf {
  Voxel low;
  int edge = 1;
  float log_odds = 0.0f;  // of .bt: -1 free, 1 occupied
};

inline constexpr std::size_t kMaxBlocks = std::size_t{1} << 17;  // 8 x 8 x 8 voxels each

/// Checks the whole tree, or throws InputError; then visits the leaves in the order of the file.
void walk_octree(std::string_view bytes, const OctreeHeader& header, const std::string& name,
                 const std::function<void(const OctreeLeaf&)>& visit);

}  // namespace amiss::mapping
