#include "mapping/internal/evidence.hpp"

#include <algorithm>

namespace amiss::mapping {

void HitCounts::note(std::uint32_t slot, const BlockEvidence& evidence, const ValueBlock& after) {
  if (slot >= counts_.size()) counts_.resize(slot + 1, {});
  auto& counts = counts_[slot];
  for (std::size_t layer = 0; layer < kBlockEdge; ++layer) {
    const std::uint64_t lost = evidence.miss[layer] & ~after.occupied[layer];
    const std::size_t first = layer * kBlockEdge * kBlockEdge;
    for (std::uint64_t rest = evidence.hit[layer]; rest != 0; rest &= rest - 1) {
      std::uint8_t& count = counts[first + static_cast<std::size_t>(std::countr_zero(rest))];
      if (count != 255) ++count;
    }
    if (lost == ~std::uint64_t{0}) {
      std::fill_n(counts.begin() + static_cast<std::ptrdiff_t>(first), kBlockEdge * kBlockEdge, std::uint8_t{0});
      continue;
    }
    for (std::uint64_t rest = lost; rest != 0; rest &= rest - 1) {
      counts[first + static_cast<std::size_t>(std::countr_zero(rest))] = 0;
    }
  }
}

void HitCounts::clear(std::uint32_t slot, unsigned index) {
  if (slot < counts_.size()) counts_[slot][index] = 0;
}

int HitCounts::at(std::uint32_t slot, unsigned index) const { return slot < counts_.size() ? counts_[slot][index] : 0; }

}  // namespace amiss::mapping
