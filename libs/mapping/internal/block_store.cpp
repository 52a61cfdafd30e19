// The fast store: 512 log-odds of 16 bits for each block, updated a row of eight voxels at a time.
#include <algorithm>
#include <array>

#include "mapping/internal/store.hpp"

namespace amiss::mapping {
namespace {

constexpr std::size_t kRow = kBlockEdge;
using Row = std::array<std::int16_t, kRow>;

/// kSpread[byte][i] is all ones where bit i of the byte is set.
constexpr auto kSpread = [] {
  std::array<Row, 256> spread{};
  for (std::size_t byte = 0; byte < spread.size(); ++byte) {
    for (std::size_t i = 0; i < kRow; ++i) spread[byte][i] = static_cast<std::int16_t>((byte >> i) & 1u ? -1 : 0);
  }
  return spread;
}();

/// New log-odds of a row; returns whether a sign changed.
bool update_row(std::int16_t* row, const Row& hit, const Row& miss, const LogOddsSteps& steps) {
  std::int16_t flipped = 0;
  for (std::size_t i = 0; i < kRow; ++i) {
    const auto before = row[i];
    auto value = static_cast<std::int16_t>(before + (hit[i] & steps.hit) + (miss[i] & steps.miss));
    value = std::min(std::max(value, steps.low), steps.high);
    flipped = static_cast<std::int16_t>(flipped | (before ^ value));
    row[i] = value;
  }
  return flipped < 0;
}

std::uint64_t occupied_bits(const std::int16_t* row) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kRow; ++i) bits |= static_cast<std::uint64_t>(row[i] >= 0 ? 1u : 0u) << i;
  return bits;
}

class BlockStore : public VoxelMap::Store {
 public:
  explicit BlockStore(const LogOddsSteps& steps) : steps_(steps) {}

  [[nodiscard]] std::unique_ptr<VoxelMap::Store> clone() const override { return std::make_unique<BlockStore>(*this); }

  bool apply(std::uint32_t slot, const BlockEvidence& evidence, ValueBlock& block) override {
    Cells& cells = cells_of(slot);
    const bool all_missed = evidence.all_missed();
    if (all_missed && cells.settled_free) return false;
    cells.settled_free = false;
    bool changed = false;
    for (std::size_t layer = 0; layer < kBlockEdge; ++layer) {
      changed |= apply_layer(cells, layer, evidence, block);
    }
    if (all_missed) {
      cells.settled_free =
          std::all_of(cells.steps.begin(), cells.steps.end(), [this](std::int16_t s) { return s == steps_.low; });
    }
    return changed;
  }

  void set(std::uint32_t slot, Voxel v, std::optional<std::int16_t> steps) override {
    Cells& cells = cells_of(slot);
    cells.steps[index_in_block(v)] = std::clamp(steps.value_or(std::int16_t{0}), steps_.low, steps_.high);
    cells.settled_free = false;
  }

  [[nodiscard]] std::int16_t steps(std::uint32_t slot, Voxel v) const override {
    return slot < cells_.size() ? cells_[slot].steps[index_in_block(v)] : std::int16_t{0};
  }

 private:
  struct Cells {
    std::array<std::int16_t, kBlockVoxels> steps{};  // 0 where unknown
    bool settled_free = false;                       // all known and at the lower clamp
  };

  Cells& cells_of(std::uint32_t slot) {
    if (slot >= cells_.size()) cells_.resize(slot + 1);
    return cells_[slot];
  }

  bool apply_layer(Cells& cells, std::size_t layer, const BlockEvidence& evidence, ValueBlock& block) {
    const std::uint64_t hit = evidence.hit[layer], miss = evidence.miss[layer];
    const std::uint64_t fresh = (hit | miss) & ~block.known[layer];
    std::uint64_t occupied = block.occupied[layer];
    for (std::size_t y = 0; y < kBlockEdge; ++y) {
      const auto shift = static_cast<unsigned>(8 * y);
      const std::size_t hit_row = (hit >> shift) & 0xffu, miss_row = (miss >> shift) & 0xffu;
      if ((hit_row | miss_row) == 0) continue;
      std::int16_t* row = &cells.steps[layer * kBlockEdge * kBlockEdge + y * kRow];
      const bool flipped = update_row(row, kSpread[hit_row], kSpread[miss_row], steps_);
      if (!flipped && ((fresh >> shift) & 0xffu) == 0) continue;
      occupied = (occupied & ~(std::uint64_t{0xff} << shift)) | (occupied_bits(row) << shift);
    }
    const std::uint64_t known = block.known[layer] | fresh;
    occupied &= known;
    const bool changed = fresh != 0 || occupied != block.occupied[layer];
    block.known[layer] = known;
    block.occupied[layer] = occupied;
    return changed;
  }

  LogOddsSteps steps_;
  std::vector<Cells> cells_;
};

}  // namespace

std::unique_ptr<VoxelMap::Store> make_block_store(const LogOddsSteps& steps) {
  return std::make_unique<BlockStore>(steps);
}

}  // namespace amiss::mapping
