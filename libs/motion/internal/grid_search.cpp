#include "motion/internal/grid_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace amiss::motion::internal {
namespace {

constexpr int kBorder = 2;  // impassable cells round the grid, so that no move needs a check of the borders

struct Move {
  int dx, dy;
  float cells;                  // length
  std::array<Cell, 2> through;  // cells that the straight move touches
};

constexpr float kDiagonal = 1.41421356F, kKnight = 2.23606798F;

constexpr std::array<Move, 16> kMoves{{
    {1, 0, 1.0F, {{{0, 0}, {0, 0}}}},
    {-1, 0, 1.0F, {{{0, 0}, {0, 0}}}},
    {0, 1, 1.0F, {{{0, 0}, {0, 0}}}},
    {0, -1, 1.0F, {{{0, 0}, {0, 0}}}},
    {1, 1, kDiagonal, {{{1, 0}, {0, 1}}}},
    {-1, 1, kDiagonal, {{{-1, 0}, {0, 1}}}},
    {1, -1, kDiagonal, {{{1, 0}, {0, -1}}}},
    {-1, -1, kDiagonal, {{{-1, 0}, {0, -1}}}},
    {2, 1, kKnight, {{{1, 0}, {1, 1}}}},
    {1, 2, kKnight, {{{0, 1}, {1, 1}}}},
    {-2, 1, kKnight, {{{-1, 0}, {-1, 1}}}},
    {-1, 2, kKnight, {{{0, 1}, {-1, 1}}}},
    {2, -1, kKnight, {{{1, 0}, {1, -1}}}},
    {1, -2, kKnight, {{{0, -1}, {1, -1}}}},
    {-2, -1, kKnight, {{{-1, 0}, {-1, -1}}}},
    {-1, -2, kKnight, {{{0, -1}, {-1, -1}}}},
}};

/// The box of the map that can be passable, with a border: all that a move asks for in one place.
class Board {
 public:
  Board(const DriveMap& map, double clearance_weight) : low_(map.box().low), stride_(map.box().width() + 2 * kBorder) {
    const CellBox& box = map.box();
    const auto size = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(box.height() + 2 * kBorder);
    weight_.assign(size, 0.0F);
    cost_.assign(size, std::numeric_limits<float>::infinity());
    came_from_.assign(size, kNoMove);
    for (int y = box.low.y; y <= box.high.y; ++y) {
      for (int x = box.low.x; x <= box.high.x; ++x) {
        if (!map.passable({x, y})) continue;
        weight_[at({x, y})] =
            clearance_weight > 0.0 ? weight_at(map.params(), clearance_weight, map.clearance_at(Cell{x, y})) : 1.0F;
      }
    }
    for (std::size_t i = 0; i < kMoves.size(); ++i) {
      step_[i] = offset({kMoves[i].dx, kMoves[i].dy});
      through_[i] = {offset(kMoves[i].through[0]), offset(kMoves[i].through[1])};
    }
  }

  [[nodiscard]] std::size_t at(Cell c) const {
    return static_cast<std::size_t>((c.y - low_.y + kBorder) * stride_ + c.x - low_.x + kBorder);
  }

  /// Costs in cells, until the goal or all is settled.
  void run(std::size_t start, float start_cost, std::size_t goal, float largest_weight) {
    std::vector<std::vector<std::uint32_t>> buckets(static_cast<std::size_t>(kKnight * largest_weight) + 3);
    cost_[start] = start_cost;
    auto level = static_cast<std::size_t>(start_cost);
    buckets[level % buckets.size()].push_back(static_cast<std::uint32_t>(start));
    for (std::size_t waiting = 1; waiting > 0; ++level) {
      std::vector<std::uint32_t>& bucket = buckets[level % buckets.size()];
      for (std::size_t i = 0; i < bucket.size(); ++i) {
        --waiting;
        const std::size_t cell = bucket[i];
        if (static_cast<std::size_t>(cost_[cell]) == level) waiting += expand(cell, buckets);
      }
      bucket.clear();
      if (static_cast<std::size_t>(std::min(cost_[goal], 1e9F)) <= level) return;
    }
  }

  [[nodiscard]] float cost(Cell c) const { return cost_[at(c)]; }
  [[nodiscard]] std::uint8_t came_from(Cell c) const { return came_from_[at(c)]; }

 private:
  [[nodiscard]] std::ptrdiff_t offset(Cell c) const { return std::ptrdiff_t{c.y} * stride_ + c.x; }
  [[nodiscard]] float weight(std::size_t cell, std::ptrdiff_t step) const {
    return weight_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + step)];
  }

  std::size_t expand(std::size_t cell, std::vector<std::vector<std::uint32_t>>& buckets) {
    std::size_t pushed = 0;
    for (std::size_t i = 0; i < kMoves.size(); ++i) {
      const float there = weight(cell, step_[i]);
      if (there == 0.0F) continue;
      const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + step_[i]);
      const float cost = cost_[cell] + 0.5F * kMoves[i].cells * (weight_[cell] + there);
      if (cost >= cost_[next]) continue;
      if (weight(cell, through_[i][0]) == 0.0F || weight(cell, through_[i][1]) == 0.0F) continue;
      cost_[next] = cost;
      came_from_[next] = static_cast<std::uint8_t>(i);
      buckets[static_cast<std::size_t>(cost) % buckets.size()].push_back(static_cast<std::uint32_t>(next));
      ++pushed;
    }
    return pushed;
  }

  Cell low_;
  int stride_;
  std::vector<float> weight_;  // 0: impassable
  std::vector<float> cost_;
  std::vector<std::uint8_t> came_from_;
  std::array<std::ptrdiff_t, kMoves.size()> step_{};
  std::array<std::array<std::ptrdiff_t, 2>, kMoves.size()> through_{};
};

}  // namespace

SearchField search(const DriveMap& map, Cell start, float start_cost_m, const SearchLimits& limits) {
  const FloorGrid& grid = map.grid();
  const auto resolution = static_cast<float>(grid.resolution_m());
  Board board(map, limits.clearance_weight);
  const std::size_t goal = limits.goal ? board.at(*limits.goal) : 0;  // cell 0 lies in the border
  board.run(board.at(start), start_cost_m / resolution, goal, static_cast<float>(1.0 + limits.clearance_weight));
  SearchField field;
  field.cost_m.assign(grid.cells().size(), std::numeric_limits<float>::infinity());
  field.came_from.assign(grid.cells().size(), kNoMove);
  for (int y = map.box().low.y; y <= map.box().high.y; ++y) {
    for (int x = map.box().low.x; x <= map.box().high.x; ++x) {
      field.cost_m[grid.index({x, y})] = board.cost({x, y}) * resolution;
      field.came_from[grid.index({x, y})] = board.came_from({x, y});
    }
  }
  return field;
}

std::vector<Cell> trace(const FloorGrid& grid, const SearchField& field, Cell c) {
  std::vector<Cell> cells;
  if (!grid.contains(c) || !std::isfinite(field.cost_m[grid.index(c)])) return cells;
  cells.push_back(c);
  while (field.came_from[grid.index(c)] != kNoMove) {
    const Move& move = kMoves[field.came_from[grid.index(c)]];
    c = {c.x - move.dx, c.y - move.dy};
    cells.push_back(c);
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

}  // namespace amiss::motion::internal
