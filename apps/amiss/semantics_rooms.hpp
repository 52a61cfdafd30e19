// The rooms of the data set as the robot's camera sees them, with the class of each point: what labellers are measured
// on. Each is looked at from its waypoints, with objects of one visit in it and its things a little nudged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "training/sampler.hpp"

namespace amiss::app {

struct RoomSample {
  std::string room;
  training::LabelledCloud labelled;
};

/// Of all rooms where no names are given. ArgumentError with the nearest name for one that is not there.
[[nodiscard]] std::vector<RoomSample> sampled_rooms(const std::vector<std::string>& names, std::uint64_t seed,
                                                    int threads);

}  // namespace amiss::app
