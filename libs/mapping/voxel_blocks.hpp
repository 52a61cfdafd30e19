// The three values of a voxel map as bit planes: blocks of 8 x 8 x 8 voxels in a hash table, one 64-bit word for each
// layer of a block, one plane "known" and one plane "occupied". Dilation, difference and projection are shifts and ORs
// on these words. Every block remembers the revision in which one of its values changed last.
//
// Voxel (x, y, z) covers [x res, (x+1) res) and likewise in y and z of the map frame; indices lie in +-kVoxelLimit,
// the range of an OctoMap key.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/floor_grid.hpp"

namespace amiss::mapping {

struct Voxel {
  int x = 0, y = 0, z = 0;
  auto operator<=>(const Voxel&) const = default;
};

inline constexpr int kVoxelLimit = 32768;  // -kVoxelLimit <= index < kVoxelLimit
inline constexpr int kBlockEdge = 8;       // voxels
inline constexpr int kBlockVoxels = kBlockEdge * kBlockEdge * kBlockEdge;

/// A block's place: voxel index divided by 8, rounded down.
struct BlockKey {
  int x = 0, y = 0, z = 0;
  auto operator<=>(const BlockKey&) const = default;
};

[[nodiscard]] constexpr BlockKey block_of(Voxel v) { return {v.x >> 3, v.y >> 3, v.z >> 3}; }
[[nodiscard]] constexpr bool in_limits(Voxel v) {
  return v.x >= -kVoxelLimit && v.x < kVoxelLimit && v.y >= -kVoxelLimit && v.y < kVoxelLimit && v.z >= -kVoxelLimit &&
         v.z < kVoxelLimit;
}
[[nodiscard]] constexpr unsigned bit_in_layer(Voxel v) {
  return static_cast<unsigned>((v.y & 7) * kBlockEdge + (v.x & 7));
}
[[nodiscard]] constexpr unsigned index_in_block(Voxel v) {
  return static_cast<unsigned>((v.z & 7) * kBlockEdge * kBlockEdge) + bit_in_layer(v);
}
[[nodiscard]] constexpr Voxel voxel_in(BlockKey block, int layer, int bit) {
  return {block.x * kBlockEdge + (bit & 7), block.y * kBlockEdge + (bit >> 3), block.z * kBlockEdge + layer};
}

/// 512 bits: word l is layer z = l of the block, bit 8 y + x of it is column (x, y).
using BlockBits = std::array<std::uint64_t, kBlockEdge>;

/// The values of one block. An occupied voxel is known as well.
struct ValueBlock {
  BlockKey key;
  std::uint64_t revision = 0;  // of the last change of a value
  BlockBits known{}, occupied{};

  [[nodiscard]] std::uint64_t free(std::size_t layer) const { return known[layer] & ~occupied[layer]; }
};

/// Hash table of blocks; a block keeps its slot (0, 1, 2, ... in order of creation) for life.
class VoxelBlocks {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  [[nodiscard]] std::uint32_t find(BlockKey key) const;        // slot or kNone
  std::uint32_t find_or_add(BlockKey key);                     // slot
  [[nodiscard]] const ValueBlock* block(BlockKey key) const {  // nullptr where nothing is known
    const std::uint32_t slot = find(key);
    return slot == kNone ? nullptr : &blocks_[slot];
  }
  [[nodiscard]] ValueBlock& at_slot(std::uint32_t slot) { return blocks_[slot]; }
  [[nodiscard]] const std::vector<ValueBlock>& blocks() const { return blocks_; }

  [[nodiscard]] Occupancy at(Voxel v) const {
    const ValueBlock* b = block(block_of(v));
    if (b == nullptr) return Occupancy::kUnknown;
    const auto layer = static_cast<std::size_t>(v.z & 7);
    const unsigned bit = bit_in_layer(v);
    if (((b->known[layer] >> bit) & 1u) == 0) return Occupancy::kUnknown;
    return ((b->occupied[layer] >> bit) & 1u) != 0 ? Occupancy::kOccupied : Occupancy::kFree;
  }

 private:
  void grow();

  std::vector<ValueBlock> blocks_;
  std::vector<std::uint32_t> table_;  // slots, open addressing, a power of two long
};

/// Calls visit(Voxel) for every set bit, in the order of the bits.
template <class Visit>
void for_each_bit(BlockKey key, const BlockBits& bits, Visit visit) {
  for (int layer = 0; layer < kBlockEdge; ++layer) {
    for (std::uint64_t rest = bits[static_cast<std::size_t>(layer)]; rest != 0; rest &= rest - 1) {
      visit(voxel_in(key, layer, std::countr_zero(rest)));
    }
  }
}

}  // namespace amiss::mapping
