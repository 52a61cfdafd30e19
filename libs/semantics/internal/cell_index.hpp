// Keys of cells -> numbers, for tables that are filled once and asked often: open addressing, no allocation for an
// entry.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "semantics/internal/cells.hpp"

namespace amiss::semantics {

class CellIndex {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// The number of the key; kNone where it has none.
  [[nodiscard]] std::uint32_t at(std::uint64_t key) const { return slots_[slot_of(key)].number; }

  /// The number of the key; it is given `number` where it has none.
  std::uint32_t at_or_put(std::uint64_t key, std::uint32_t number) {
    Slot& slot = slots_[slot_of(key)];
    if (slot.number != kNone) return slot.number;
    slot = {key, number};
    if (2 * ++used_ > slots_.size()) grow();
    return number;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t number = kNone;
  };
  /// Of the key, or the free one where it would be.
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = mixed(key) & mask;
    while (slots_[slot].number != kNone && slots_[slot].key != key) slot = (slot + 1) & mask;
    return slot;
  }
  void grow() {
    std::vector<Slot> before(4 * slots_.size());
    before.swap(slots_);
    for (const Slot& slot : before) {
      if (slot.number != kNone) slots_[slot_of(slot.key)] = slot;
    }
  }

  std::vector<Slot> slots_ = std::vector<Slot>(1024);
  std::size_t used_ = 0;
};

}  // namespace amiss::semantics
