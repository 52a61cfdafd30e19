// Morphology in x and y on the 8 x 8 bits of a block's layer, with the words of the neighbouring blocks beside it.
// in: words of 3 x 3 blocks     out: the middle word grown or shrunk by one voxel (thesis 4.2.1)
#pragma once

#include <array>
#include <cstdint>

#include "mapping/voxel_blocks.hpp"

namespace amiss::mapping {

/// Words of the 3 x 3 blocks around a layer, [1][1] in the middle; first index y.
using Neighbourhood = std::array<std::array<std::uint64_t, 3>, 3>;

/// The layer shifted so that bit (x, y) holds what was at (x - dx, y - dy), |dx|, |dy| <= 1.
[[nodiscard]] constexpr std::uint64_t row_shifted(std::uint64_t left, std::uint64_t mid, std::uint64_t right, int dx) {
  constexpr std::uint64_t kFirstColumn = 0x0101010101010101u, kLastColumn = 0x8080808080808080u;
  if (dx > 0) return ((mid & ~kLastColumn) << 1) | ((left & kLastColumn) >> 7);
  if (dx < 0) return ((mid & ~kFirstColumn) >> 1) | ((right & kFirstColumn) << 7);
  return mid;
}

/// Set where any of the 3 x 3 columns around is set.
[[nodiscard]] constexpr std::uint64_t grown(const Neighbourhood& n) {
  std::uint64_t rows[3] = {0, 0, 0};
  for (std::size_t y = 0; y < 3; ++y) {
    for (int dx = -1; dx <= 1; ++dx) rows[y] |= row_shifted(n[y][0], n[y][1], n[y][2], dx);
  }
  return rows[1] | (rows[1] << 8) | (rows[0] >> 56) | (rows[1] >> 8) | (rows[2] << 56);
}

/// Set where all of the 3 x 3 columns around are set.
[[nodiscard]] constexpr std::uint64_t shrunk(Neighbourhood n) {
  for (auto& row : n) {
    for (auto& word : row) word = ~word;
  }
  return ~grown(n);
}

/// The occupied bits of a layer of the 3 x 3 blocks around `key`; 0 where there is no block.
[[nodiscard]] inline Neighbourhood occupied_around(const VoxelBlocks& blocks, BlockKey key, std::size_t layer) {
  Neighbourhood n{};
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const ValueBlock* block = blocks.block({key.x + dx, key.y + dy, key.z});
      if (block == nullptr) continue;
      n[static_cast<std::size_t>(dy + 1)][static_cast<std::size_t>(dx + 1)] = block->occupied[layer];
    }
  }
  return n;
}

/// The keys and their neighbours in x and y, sorted, each once.
[[nodiscard]] std::vector<BlockKey> with_neighbours(const std::vector<BlockKey>& keys);

}  // namespace amiss::mapping
