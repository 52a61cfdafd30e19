#include "start_pose.hpp"

#include "sim/free_space.hpp"

namespace amiss::app {

Pose2<World, Base> start_pose(const world::World& world, const robot::Model& model, const std::vector<double>& wanted) {
  if (!wanted.empty()) return {wanted.at(0), wanted.at(1), radians(wanted.at(2))};
  return world.robot_start ? *world.robot_start : sim::free_start(world, model);
}

}  // namespace amiss::app
