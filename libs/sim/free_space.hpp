// Where the base could stand: the collision shapes of static bodies between two heights, as a grid of the floor.
// World -> FloorGrid in the world frame: occupied where a shape is, free where there is ground or nothing at all.
#pragma once

#include "core/floor_grid.hpp"
#include "world/world.hpp"

namespace amiss::sim {

/// Static collision shapes (of all bodies when `with_moving`) that reach into low_m < z < high_m.
[[nodiscard]] FloorGrid floor_plan(const world::World& world, double resolution_m, double low_m, double high_m,
                                   bool with_moving);

/// Labels of connected free cells (8 neighbours): 0 elsewhere, 1.. in order of the first cell, row-major.
[[nodiscard]] std::vector<int> connected_areas(const FloorGrid& grid);

}  // namespace amiss::sim
