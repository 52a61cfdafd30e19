// Furniture and permanent things that stand a little elsewhere, as people leave them: centimetres and a few degrees.
// World with its semantic classes, random stream -> nudges (world/nudges.hpp). What stands on a nudged body goes with
// it; nothing is pushed into something else. Walls, floors, doors, windows, pictures, what is built in and what stands
// on nothing stay.
#pragma once

#include <vector>

#include "core/params.hpp"
#include "core/random.hpp"
#include "world/class_table.hpp"
#include "world/nudges.hpp"

namespace amiss::sim {

struct NudgingParams {
  double part = 0.6;                   // of the bodies that can be nudged
  double furniture_shift_m = 0.03;     // at most, along x and y, of what stands on the floor
  double furniture_yaw_rad = radians(2.0);
  double thing_shift_m = 0.04;         // of what stands on furniture
  double thing_yaw_rad = radians(10.0);
};
void describe(ParamTable& table, NudgingParams& params);

[[nodiscard]] std::vector<world::Nudge> random_nudges(const world::World& world, const world::ClassTable& classes,
                                                      const NudgingParams& params, RandomStream& random);

}  // namespace amiss::sim
