// Where the robot stands when a run begins: where the user says, where the world says, else where there is room.
// World, robot, {x m, y m, heading degrees} of the world frame or nothing -> pose. InputError where there is no room.
#pragma once

#include <vector>

#include "robot/model.hpp"
#include "world/world.hpp"

namespace amiss::app {

[[nodiscard]] Pose2<World, Base> start_pose(const world::World& world, const robot::Model& model,
                                            const std::vector<double>& wanted);

}  // namespace amiss::app
