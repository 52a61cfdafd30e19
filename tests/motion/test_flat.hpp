// A flat drawn by hand: 12 m x 7.5 m, five rooms, doors of 0.9 m, furniture. Used by tests of view and motion.
#pragma once

#include "core/floor_grid.hpp"

namespace amiss {

inline void fill_rect(FloorGrid& grid, double x0, double y0, double x1, double y1, Occupancy value) {
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Eigen::Vector2d p = grid.centre_of({x, y});
      if (p.x() > x0 && p.x() < x1 && p.y() > y0 && p.y() < y1) grid.set({x, y}, value);
    }
  }
}

/// Free inside, walls of 0.1 m round it, 0.3 m of unknown outside. The inside begins at (0, 0).
inline FloorGrid empty_room(double width_m, double height_m, double resolution_m = 0.05) {
  const double outside = 0.4;
  FloorGrid grid(resolution_m, Eigen::Vector2d(-outside, -outside),
                 static_cast<int>(std::lround((width_m + 2 * outside) / resolution_m)),
                 static_cast<int>(std::lround((height_m + 2 * outside) / resolution_m)));
  fill_rect(grid, -0.1, -0.1, width_m + 0.1, height_m + 0.1, Occupancy::kOccupied);
  fill_rect(grid, 0, 0, width_m, height_m, Occupancy::kFree);
  return grid;
}

/// Living room (left), hall across, two rooms and a bath on the right.
inline FloorGrid test_flat() {
  FloorGrid grid = empty_room(12.0, 7.5);
  const auto wall = [&](double x0, double y0, double x1, double y1) {
    fill_rect(grid, x0, y0, x1, y1, Occupancy::kOccupied);
  };
  const auto door = [&](double x0, double y0, double x1, double y1) {
    fill_rect(grid, x0, y0, x1, y1, Occupancy::kFree);
  };
  wall(5.0, 0.0, 5.1, 7.5);
  wall(5.1, 3.0, 12.0, 3.1);
  wall(5.1, 4.4, 12.0, 4.5);
  wall(8.5, 4.5, 8.6, 7.5);
  wall(8.0, 0.0, 8.1, 3.0);
  door(4.95, 3.3, 5.15, 4.2);
  door(6.0, 2.95, 6.9, 3.15);
  door(9.5, 2.95, 10.4, 3.15);
  door(6.2, 4.35, 7.1, 4.55);
  door(10.0, 4.35, 10.9, 4.55);
  wall(0.0, 1.0, 0.9, 3.0);    // sofa
  wall(1.8, 1.6, 2.8, 2.4);    // coffee table
  wall(0.5, 6.9, 3.0, 7.5);    // cupboard
  wall(3.0, 5.0, 4.2, 5.8);    // dining table
  wall(5.1, 0.0, 5.7, 1.6);    // desk
  wall(10.5, 0.0, 12.0, 2.0);  // bed
  wall(5.1, 6.9, 7.5, 7.5);    // shelf
  wall(11.2, 6.0, 12.0, 7.5);  // desk
  return grid;
}

}  // namespace amiss
