// How a data set is to be recorded in a world: a row of sim_worlds/dataset.yaml.
// File -> plans in its order. Errors: InputError with file, line, what is wrong and what is allowed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/frames.hpp"

namespace amiss::world {

struct RoomPlan {
  std::string world;         // name of the world
  std::vector<int> objects;  // of each visit after the tidy one
  double lift_m = 0.0;       // of the torso, all the time
  std::vector<Pose2<amiss::World, Base>> waypoints;
};

[[nodiscard]] std::vector<RoomPlan> load_room_plans(const std::filesystem::path& file);

}  // namespace amiss::world
