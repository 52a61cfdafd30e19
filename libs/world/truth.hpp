// What really is where, at one instant. Only world, sim, score and apps may include this.
#pragma once

#include <string>
#include <vector>

#include "core/frames.hpp"
#include "core/stamp.hpp"

namespace amiss::world {

/// One scattered object: where its body is and its axis-aligned bounds in the world frame [m].
struct ObjectTruth {
  std::string name;        // unique in the world
  std::string kind;        // name in the catalogue
  std::uint16_t instance;  // value of its pixels in InstanceImage
  Transform<amiss::World, Object> pose;
  Eigen::AlignedBox3d bounds;
};

struct Truth {
  Stamp stamp;
  Pose2<amiss::World, Base> T_world_base;
  std::vector<ObjectTruth> objects;
};

/// Per pixel which body it shows (body index + 1, 0 is nothing), for the frame of the same stamp, row-major.
struct InstanceImage {
  Stamp stamp;
  int width = 0, height = 0;
  std::vector<std::uint16_t> instances;
};

/// A touch of the robot's body with something other than the floor.
struct Collision {
  Stamp stamp;
  std::string link, body;
  Point<amiss::World> position;
};

}  // namespace amiss::world
