// A 2D occupancy grid of the floor in the map frame, three values.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/frames.hpp"

namespace amiss {

enum class Occupancy : std::uint8_t { kUnknown = 0, kFree = 1, kOccupied = 2 };

struct Cell {
  int x = 0, y = 0;
  bool operator==(const Cell&) const = default;
};

/// Cell (x, y) covers [origin + x res, origin + (x+1) res) and likewise in y; row-major, y up.
class FloorGrid {
 public:
  FloorGrid() = default;
  FloorGrid(double resolution_m, Eigen::Vector2d origin_m, int width, int height, Occupancy fill = Occupancy::kUnknown);

  [[nodiscard]] double resolution_m() const { return resolution_m_; }
  [[nodiscard]] Eigen::Vector2d origin_m() const { return origin_m_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_; }
  [[nodiscard]] Cell cell_at(const Eigen::Vector2d& p_map) const;  // may lie outside
  [[nodiscard]] Eigen::Vector2d centre_of(Cell c) const;
  [[nodiscard]] Occupancy at(Cell c) const {  // outside is unknown
    return contains(c) ? cells_[index(c)] : Occupancy::kUnknown;
  }
  [[nodiscard]] Occupancy at(const Eigen::Vector2d& p_map) const { return at(cell_at(p_map)); }
  void set(Cell c, Occupancy value) { cells_[index(c)] = value; }  // c must be inside
  [[nodiscard]] std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(c.x);
  }
  [[nodiscard]] const std::vector<Occupancy>& cells() const { return cells_; }
  bool operator==(const FloorGrid&) const = default;

 private:
  double resolution_m_ = 0.05;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  int width_ = 0, height_ = 0;
  std::vector<Occupancy> cells_;
};

/// The grid with every occupied cell grown to a (2 radius + 1)^2 square.
[[nodiscard]] FloorGrid dilated(const FloorGrid& grid, int radius_cells);

/// Distance [m] from each cell's centre to the nearest centre of an occupied cell (exact Euclidean, Felzenszwalb and
/// Huttenlocher 2012); `unknown_is_occupied` decides for unknown cells. Row-major as the grid.
[[nodiscard]] std::vector<float> distance_to_occupied_m(const FloorGrid& grid, bool unknown_is_occupied);

/// Is every cell that the segment a-b touches free? (Amanatides and Woo 1987.)
[[nodiscard]] bool line_of_sight(const FloorGrid& grid, const Eigen::Vector2d& a_map, const Eigen::Vector2d& b_map);

}  // namespace amiss
