// What a robot of a given height bumps into: a VoxelMap's column range [z_low, z_high) projected onto the floor.
//
// in: VoxelMap, again and again     out: FloorGrid of obstacles and of floor seen, both in the map frame at the map's
// resolution. Only columns of blocks that changed since the last update are projected anew.
//   obstacles: occupied where any voxel of the range is occupied, else free where the floor was seen, else unknown.
//   seen floor: free where any voxel of the floor range is known, else unknown. Thesis 4.2.2/4.3.2 (coverage).
#pragma once

#include "core/floor_grid.hpp"
#include "core/params.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

struct ObstacleLayerParams {
  double z_low_m = 0.0;  // of the obstacles; the floor lies just under 0
  double z_high_m = 1.1;
  double floor_low_m = -0.05;  // where a known voxel says that the floor was seen
  double floor_high_m = 0.05;
};
void describe(ParamTable& table, ObstacleLayerParams& params);

class ObstacleLayer {
 public:
  /// The layer covers the area of `like` (its resolution and values do not matter) in cells of `resolution_m`.
  ObstacleLayer(const FloorGrid& like, double resolution_m, const ObstacleLayerParams& params = {});

  /// Bring the grids up to date. A map of another resolution throws ArgumentError. Returns whether a cell changed.
  bool update(const VoxelMap& map);

  [[nodiscard]] const FloorGrid& obstacles() const { return obstacles_; }
  [[nodiscard]] const FloorGrid& seen_floor() const { return seen_floor_; }
  [[nodiscard]] std::size_t seen_cells() const { return seen_cells_; }

 private:
  bool project(const VoxelMap& map, int block_x, int block_y);
  bool set_cell(Cell cell, bool occupied, bool seen);

  ObstacleLayerParams params_;
  int cell_x_ = 0, cell_y_ = 0;  // voxel index of cell (0, 0)
  FloorGrid obstacles_, seen_floor_;
  std::size_t seen_cells_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace amiss::mapping
