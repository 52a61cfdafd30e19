// What a recording begins with, so that a replay of it needs nothing else: seed and method of the run, the robot, the
// floor of the reference, and documents by name (parameters, the world, the files of the reference).
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/floor_grid.hpp"
#include "robot/model.hpp"

namespace amiss::recording {

struct RunSetup {
  std::uint64_t seed = 0;
  std::string method;
  double floor_clearance_m = 0.0;
  const robot::Model* model = nullptr;  // outlives the recorder
  const FloorGrid* floor = nullptr;     // of the reference; lives during the constructor
  std::map<std::string, std::string> documents;
};

}  // namespace amiss::recording
