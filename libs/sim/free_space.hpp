// Where the base could stand: the collision shapes of static bodies between two heights, as a grid of the floor.
// World -> FloorGrid in the world frame: occupied where a shape is, free where there is ground or nothing at all.
#pragma once

#include "core/floor_grid.hpp"
#include "robot/model.hpp"
#include "world/world.hpp"

namespace amiss::sim {

/// Static collision shapes (of all bodies when `with_moving`) that reach into low_m < z < high_m.
[[nodiscard]] FloorGrid floor_plan(const world::World& world, double resolution_m, double low_m, double high_m,
                                   bool with_moving);

/// What is lower is driven over, or belongs to the floor.
inline constexpr double kLowestObstacle_m = 0.02;

/// Free where the middle of a disc of this radius can be, occupied elsewhere.
[[nodiscard]] FloorGrid standing_room(const FloorGrid& plan, double radius_m);

/// Labels of connected free cells (8 neighbours): 0 elsewhere, 1.. in order of the first cell, row-major.
[[nodiscard]] std::vector<int> connected_areas(const FloorGrid& grid);

/// Where the robot stands when the world does not say: in the largest connected area that it can turn round in and that
/// does not reach the edge of the world (the largest of all where each does), the place with the most air round it (a
/// metre is enough), nearer to the area's middle where that is equal; heading along x. InputError when there is none.
[[nodiscard]] Pose2<amiss::World, Base> free_start(const world::World& world, const robot::Model& model);

}  // namespace amiss::sim
