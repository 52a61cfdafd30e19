// The robot's links for a page: primitives with their poses in the base frame for a head that looks straight ahead, and
// the axes that the head turns about, so that a page needs two rotations and no kinematics.
#pragma once

#include <nlohmann/json.hpp>

#include "robot/model.hpp"

namespace amiss::page {

/// Links with meshes are shown by their collision primitives.
[[nodiscard]] nlohmann::ordered_json robot_json(const robot::Model& model);

}  // namespace amiss::page
