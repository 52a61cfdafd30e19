// The cells that a straight line touches, in order (Amanatides and Woo 1987).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/floor_grid.hpp"

namespace amiss {

/// visit(cell, begin, end) with the part of the line, 0 to 1, that lies in the cell; ends early when it says false.
template <class Visit>
bool for_line_cells(const FloorGrid& grid, const Eigen::Vector2d& a_map, const Eigen::Vector2d& b_map, Visit visit) {
  const double infinity = std::numeric_limits<double>::infinity();
  Cell cell = grid.cell_at(a_map);
  const Cell last = grid.cell_at(b_map);
  const Eigen::Vector2d a = (a_map - grid.origin_m()) / grid.resolution_m();
  const Eigen::Vector2d way = (b_map - a_map) / grid.resolution_m();
  const int sign_x = way.x() > 0 ? 1 : -1, sign_y = way.y() > 0 ? 1 : -1;
  const double dx = way.x() != 0.0 ? std::abs(1.0 / way.x()) : infinity;
  const double dy = way.y() != 0.0 ? std::abs(1.0 / way.y()) : infinity;
  double next_x = way.x() != 0.0 ? (cell.x + (sign_x > 0 ? 1 : 0) - a.x()) / way.x() : infinity;
  double next_y = way.y() != 0.0 ? (cell.y + (sign_y > 0 ? 1 : 0) - a.y()) / way.y() : infinity;
  double begin = 0.0;
  for (int left = std::abs(last.x - cell.x) + std::abs(last.y - cell.y); left >= 0; --left) {
    const double end = left == 0 ? 1.0 : std::min(1.0, std::min(next_x, next_y));
    if (!visit(cell, begin, end)) return false;
    begin = end;
    if (next_x < next_y) {
      cell.x += sign_x;
      next_x += dx;
    } else {
      cell.y += sign_y;
      next_y += dy;
    }
  }
  return true;
}

}  // namespace amiss
