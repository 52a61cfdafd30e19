#include "mapping/obstacle_layer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/result.hpp"

namespace amiss::mapping {
namespace {

/// Layers first .. last - 1, in voxels, of heights [low, high).
struct Layers {
  int first = 0, last = 0;
};

Layers layers_of(double low_m, double high_m, double resolution_m) {
  constexpr double kSpare = 1e-6;  // heights on a border between two layers belong to the upper one
  return {static_cast<int>(std::floor(low_m / resolution_m + kSpare)),
          static_cast<int>(std::ceil(high_m / resolution_m - kSpare))};
}

struct ColumnWords {
  std::uint64_t known = 0, occupied = 0;
};

ColumnWords project_layers(const VoxelBlocks& values, int block_x, int block_y, Layers layers) {
  ColumnWords words;
  for (int z = layers.first; z < layers.last;) {
    const int block_end = std::min(((z >> 3) + 1) * kBlockEdge, layers.last);
    const ValueBlock* block = values.block({block_x, block_y, z >> 3});
    for (; z < block_end; ++z) {
      if (block == nullptr) continue;
      words.known |= block->known[static_cast<std::size_t>(z & 7)];
      words.occupied |= block->occupied[static_cast<std::size_t>(z & 7)];
    }
  }
  return words;
}

}  // namespace

void describe(ParamTable& table, ObstacleLayerParams& p) {
  table.number("obstacles.z_low", p.z_low_m, "m", -1, 3, "lower end of the heights in which voxels are obstacles");
  table.number("obstacles.z_high", p.z_high_m, "m", -1, 3, "upper end of them");
  table.number("obstacles.floor_low", p.floor_low_m, "m", -1, 1, "lower end of the heights that show the floor");
  table.number("obstacles.floor_high", p.floor_high_m, "m", -1, 1, "upper end of them");
}

ObstacleLayer::ObstacleLayer(const FloorGrid& like, double resolution_m, const ObstacleLayerParams& params)
    : params_(params) {
  if (!(params.z_low_m < params.z_high_m && params.floor_low_m < params.floor_high_m)) {
    throw ArgumentError("obstacles.z_low and obstacles.floor_low must be less than obstacles.z_high and floor_high");
  }
  constexpr double kSpare = 1e-6;
  const Eigen::Vector2d low = like.origin_m() / resolution_m;
  const Eigen::Vector2d high = low + Eigen::Vector2d(like.width(), like.height()) * like.resolution_m() / resolution_m;
  cell_x_ = static_cast<int>(std::floor(low.x() + kSpare));
  cell_y_ = static_cast<int>(std::floor(low.y() + kSpare));
  const int width = static_cast<int>(std::ceil(high.x() - kSpare)) - cell_x_;
  const int height = static_cast<int>(std::ceil(high.y() - kSpare)) - cell_y_;
  obstacles_ = FloorGrid(resolution_m, Eigen::Vector2d(cell_x_, cell_y_) * resolution_m, width, height);
  seen_floor_ = obstacles_;
}

bool ObstacleLayer::update(const VoxelMap& map) {
  if (std::abs(map.resolution_m() - obstacles_.resolution_m()) > 1e-9) {
    throw ArgumentError("obstacle layer: the map's resolution must be the layer's");
  }
  std::vector<std::pair<int, int>> columns;
  for (const BlockKey& key : map.blocks_changed_since(revision_)) columns.emplace_back(key.x, key.y);
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  bool changed = false;
  for (const auto& [x, y] : columns) changed |= project(map, x, y);
  revision_ = map.revision();
  return changed;
}

bool ObstacleLayer::project(const VoxelMap& map, int block_x, int block_y) {
  const double res = map.resolution_m();
  const ColumnWords body =
      project_layers(map.values(), block_x, block_y, layers_of(params_.z_low_m, params_.z_high_m, res));
  const ColumnWords floor =
      project_layers(map.values(), block_x, block_y, layers_of(params_.floor_low_m, params_.floor_high_m, res));
  bool changed = false;
  for (int bit = 0; bit < kBlockEdge * kBlockEdge; ++bit) {
    const Voxel v = voxel_in({block_x, block_y, 0}, 0, bit);
    const Cell cell{v.x - cell_x_, v.y - cell_y_};
    if (!obstacles_.contains(cell)) continue;
    changed |= set_cell(cell, ((body.occupied >> bit) & 1u) != 0, ((floor.known >> bit) & 1u) != 0);
  }
  return changed;
}

bool ObstacleLayer::set_cell(Cell cell, bool occupied, bool seen) {
  const Occupancy open = seen ? Occupancy::kFree : Occupancy::kUnknown;
  const Occupancy value = occupied ? Occupancy::kOccupied : open;
  if (obstacles_.at(cell) == value && seen_floor_.at(cell) == open) return false;
  if (seen_floor_.at(cell) == Occupancy::kFree) --seen_cells_;
  if (seen) ++seen_cells_;
  obstacles_.set(cell, value);
  seen_floor_.set(cell, open);
  return true;
}

}  // namespace amiss::mapping
