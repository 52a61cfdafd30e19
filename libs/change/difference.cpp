#include "change/difference.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/result.hpp"
#include "mapping/plane_ops.hpp"

namespace amiss::change {

using mapping::BlockBits;
using mapping::BlockKey;
using mapping::kBlockEdge;
using mapping::ValueBlock;
using mapping::Voxel;
using mapping::VoxelBlocks;
using mapping::VoxelMap;

namespace {

void require_same_resolution(const VoxelMap& reference, const VoxelMap& current) {
  if (std::abs(reference.resolution_m() - current.resolution_m()) > 1e-9) {
    throw ArgumentError("difference: the maps must have the same resolution, not " +
                        std::to_string(reference.resolution_m()) + " m and " + std::to_string(current.resolution_m()) +
                        " m");
  }
}

/// The occupied voxels that stay when the dilation is taken back.
VoxelBlocks undilated(const VoxelBlocks& dilated, int radius) {
  VoxelBlocks now = dilated;
  for (int i = 0; i < radius; ++i) {
    VoxelBlocks next = now;
    for (std::uint32_t slot = 0; slot < next.blocks().size(); ++slot) {
      ValueBlock& block = next.at_slot(slot);
      for (std::size_t l = 0; l < kBlockEdge; ++l) {
        block.occupied[l] = mapping::shrunk(mapping::occupied_around(now, block.key, l));
      }
    }
    now = std::move(next);
  }
  return now;
}

/// Is the voxel's column inside the known part of the grid and not on an occupied cell?
bool column_is_clear(const FloorGrid& dilated_grid, double resolution_m, int x, int y) {
  return dilated_grid.at(Eigen::Vector2d((x + 0.5) * resolution_m, (y + 0.5) * resolution_m)) == Occupancy::kFree;
}

}  // namespace

void describe(ParamTable& table, DifferenceParams& p) {
  table.integer("change.grid_dilation", p.grid_dilation_cells, 0, 20,
                "cells by which occupied cells of the 2D grid grow; 2 = the 5 x 5 square of 4.2.4");
  table.integer("change.reference_dilation", p.reference_dilation_voxels, 0, 5,
                "voxels by which the reference was dilated in x and y (4.2.1)");
}

bool Differencer::BlockDifference::empty() const {
  std::uint64_t any = 0;
  for (std::size_t l = 0; l < kBlockEdge; ++l) any |= appeared[l] | vanished[l];
  return any == 0;
}

Differencer::Differencer(VoxelMap reference, const std::optional<FloorGrid>& reference_grid,
                         const DifferenceParams& params)
    : reference_(std::move(reference)), undilated_(undilated(reference_.values(), params.reference_dilation_voxels)) {
  if (reference_grid) grid_ = dilated(*reference_grid, params.grid_dilation_cells);
  start_afresh();
}

void Differencer::start_afresh() {
  revision_ = 0;
  unseen_ = 0;
  blocks_.clear();
  unseen_in_.assign(reference_.values().blocks().size(), 0);
  const VoxelMap nothing(reference_.params());
  for (std::uint32_t slot = 0; slot < unseen_in_.size(); ++slot) compare_block(nothing, slot);
  gather();
}

const Difference& Differencer::update(const VoxelMap& current) {
  require_same_resolution(reference_, current);
  if (current.revision() < revision_) start_afresh();
  if (current.revision() == revision_) return latest_;
  for (const std::uint32_t slot : slots_to_compare(current)) compare_block(current, slot);
  revision_ = current.revision();
  gather();
  return latest_;
}

std::vector<std::uint32_t> Differencer::slots_to_compare(const VoxelMap& current) const {
  // What vanished depends on the neighbours in x and y as well. Where the reference is unknown nothing is said.
  std::vector<std::uint32_t> slots;
  std::vector<bool> listed(unseen_in_.size(), false);
  for (const ValueBlock& block : current.values().blocks()) {
    if (block.revision <= revision_) continue;
    for (int i = 0; i < 9; ++i) {
      const std::uint32_t slot =
          reference_.values().find({block.key.x + i % 3 - 1, block.key.y + i / 3 - 1, block.key.z});
      if (slot == VoxelBlocks::kNone || listed[slot]) continue;
      listed[slot] = true;
      slots.push_back(slot);
    }
  }
  return slots;
}

void Differencer::compare_block(const VoxelMap& current, std::uint32_t slot) {
  const ValueBlock& then = reference_.values().blocks()[slot];
  const BlockKey key = then.key;
  static const ValueBlock kUnknown;
  const ValueBlock* found = current.values().block(key);
  const ValueBlock& now = found != nullptr ? *found : kUnknown;
  const BlockBits& solid = undilated_.blocks()[slot].occupied;
  BlockDifference d;
  std::uint64_t any_appeared = 0;
  std::size_t unseen = 0;
  for (std::size_t l = 0; l < kBlockEdge; ++l) {
    d.appeared[l] = now.occupied[l] & then.free(l);  // Eq. 4.1
    d.vanished[l] = solid[l] & now.free(l);
    if (d.vanished[l] != 0) d.vanished[l] &= ~mapping::grown(mapping::occupied_around(current.values(), key, l));
    unseen += static_cast<std::size_t>(std::popcount(then.known[l] & ~now.known[l]));
    any_appeared |= d.appeared[l];
  }
  unseen_ += unseen - unseen_in_[slot];
  unseen_in_[slot] = unseen;
  if (any_appeared != 0) {
    const std::uint64_t clear = clear_columns(key.x, key.y);
    for (std::uint64_t& word : d.appeared) word &= clear;
  }
  if (d.empty()) {
    if (!blocks_.empty()) blocks_.erase(key);
  } else {
    blocks_[key] = d;
  }
}

std::uint64_t Differencer::clear_columns(int block_x, int block_y) {
  if (!grid_) return ~std::uint64_t{0};
  const auto [entry, fresh] = columns_.try_emplace({block_x, block_y}, 0u);
  if (fresh) {
    for (int bit = 0; bit < kBlockEdge * kBlockEdge; ++bit) {
      const Voxel v = mapping::voxel_in({block_x, block_y, 0}, 0, bit);
      if (column_is_clear(*grid_, reference_.resolution_m(), v.x, v.y)) entry->second |= std::uint64_t{1} << bit;
    }
  }
  return entry->second;
}

void Differencer::gather() {
  latest_ = {};
  for (const auto& [key, d] : blocks_) {
    mapping::for_each_bit(key, d.appeared, [this](Voxel v) { latest_.appeared.push_back(v); });
    mapping::for_each_bit(key, d.vanished, [this](Voxel v) { latest_.vanished.push_back(v); });
  }
  latest_.unseen = unseen_;
  std::sort(latest_.appeared.begin(), latest_.appeared.end());
  std::sort(latest_.vanished.begin(), latest_.vanished.end());
}

Difference difference(const VoxelMap& reference, const VoxelMap& current,
                      const std::optional<FloorGrid>& reference_grid, const DifferenceParams& params) {
  require_same_resolution(reference, current);
  const std::optional<FloorGrid> grid =
      reference_grid ? std::optional(dilated(*reference_grid, params.grid_dilation_cells)) : std::nullopt;
  const auto all_around = [](const VoxelMap& map, Voxel v, int radius) {
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) {
        if (map.at(Voxel{v.x + dx, v.y + dy, v.z}) != Occupancy::kOccupied) return false;
      }
    }
    return true;
  };
  const auto any_around = [](const VoxelMap& map, Voxel v) {
    for (int i = 0; i < 9; ++i) {
      if (map.at(Voxel{v.x + i % 3 - 1, v.y + i / 3 - 1, v.z}) == Occupancy::kOccupied) return true;
    }
    return false;
  };
  Difference d;
  reference.for_each_known([&](Voxel v, Occupancy then) {
    const Occupancy now = current.at(v);
    if (now == Occupancy::kUnknown) ++d.unseen;
    if (then == Occupancy::kFree && now == Occupancy::kOccupied &&
        (!grid || column_is_clear(*grid, reference.resolution_m(), v.x, v.y))) {
      d.appeared.push_back(v);
    }
    if (then == Occupancy::kOccupied && now == Occupancy::kFree &&
        all_around(reference, v, params.reference_dilation_voxels) && !any_around(current, v)) {
      d.vanished.push_back(v);
    }
  });
  std::sort(d.appeared.begin(), d.appeared.end());
  std::sort(d.vanished.begin(), d.vanished.end());
  return d;
}

}  // namespace amiss::change
