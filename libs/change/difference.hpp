// What is in the current voxel map but not in the reference (thesis 4.2.4, Eq. 4.1), with three values:
// a voxel has appeared where it is occupied now and the reference KNOWS it free; where the reference is unknown nothing
// is said. Voxels over an occupied cell of the dilated 2D grid, over an unknown one or outside the grid are dropped.
// A voxel has vanished where the reference (dilation taken back) is occupied, it is free now, and nothing in its 8
// neighbours in x and y is occupied now.
//
// in: reference VoxelMap (already dilated, 4.2.1), reference FloorGrid, current VoxelMap of the same resolution
// out: Difference, voxels sorted. Errors: ArgumentError when the resolutions differ.
// Differencer::update costs what changed in the current map since its last call; difference() looks at everything.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/floor_grid.hpp"
#include "core/params.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::change {

struct DifferenceParams {
  int grid_dilation_cells = 2;        // 5 x 5 cells
  int reference_dilation_voxels = 1;  // how far the reference was dilated
};
void describe(ParamTable& table, DifferenceParams& params);

struct Difference {
  std::vector<mapping::Voxel> appeared, vanished;
  std::size_t unseen = 0;  // voxels the reference knows and the current map does not
  bool operator==(const Difference&) const = default;
};

class Differencer {
 public:
  /// Without a grid every voxel counts as inside and clear.
  Differencer(mapping::VoxelMap reference, const std::optional<FloorGrid>& reference_grid,
              const DifferenceParams& params = {});

  /// `current` must be the same map, grown, at every call; with a map of a smaller revision it starts afresh.
  const Difference& update(const mapping::VoxelMap& current);
  [[nodiscard]] const Difference& latest() const { return latest_; }
  [[nodiscard]] const mapping::VoxelMap& reference() const { return reference_; }

 private:
  struct BlockDifference {
    mapping::BlockBits appeared{}, vanished{};
    [[nodiscard]] bool empty() const;
  };
  void start_afresh();
  [[nodiscard]] std::vector<std::uint32_t> slots_to_compare(const mapping::VoxelMap& current) const;
  void compare_block(const mapping::VoxelMap& current, std::uint32_t slot);  // slot of the reference
  [[nodiscard]] std::uint64_t clear_columns(int block_x, int block_y);       // of the grid, cached
  void gather();

  mapping::VoxelMap reference_;
  mapping::VoxelBlocks undilated_;                       // the reference's occupied voxels, dilation taken back
  std::optional<FloorGrid> grid_;                        // dilated
  std::map<mapping::BlockKey, BlockDifference> blocks_;  // those that are not empty
  std::vector<std::size_t> unseen_in_;                   // for each block of the reference
  std::size_t unseen_ = 0;
  std::map<std::pair<int, int>, std::uint64_t> columns_;
  std::uint64_t revision_ = 0;
  Difference latest_;
};

/// The same at once, voxel by voxel: slow and obvious. Used by tests and for maps of which nothing was known before.
[[nodiscard]] Difference difference(const mapping::VoxelMap& reference, const mapping::VoxelMap& current,
                                    const std::optional<FloorGrid>& reference_grid,
                                    const DifferenceParams& params = {});

}  // namespace amiss::change
