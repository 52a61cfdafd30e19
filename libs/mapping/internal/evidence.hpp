// What one observation says of the voxels of one block: hit, missed, or neither. A voxel is never both.
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/voxel_blocks.hpp"

namespace amiss::mapping {

struct BlockEvidence {
  BlockKey key;
  BlockBits hit{}, miss{};

  [[nodiscard]] bool empty() const {
    std::uint64_t any = 0;
    for (std::size_t l = 0; l < hit.size(); ++l) any |= hit[l] | miss[l];
    return any == 0;
  }
  [[nodiscard]] bool all_missed() const {
    std::uint64_t all = ~std::uint64_t{0};
    for (const std::uint64_t word : miss) all &= word;
    return all == ~std::uint64_t{0};
  }
};

/// In how many frames each voxel was hit, at most 255; starts over when a free voxel is missed.
class HitCounts {
 public:
  void note(std::uint32_t slot, const BlockEvidence& evidence, const ValueBlock& after);
  void clear(std::uint32_t slot, unsigned index);
  [[nodiscard]] int at(std::uint32_t slot, unsigned index) const;

 private:
  std::vector<std::array<std::uint8_t, kBlockVoxels>> counts_;
};

}  // namespace amiss::mapping
