// Rooms to learn from: walls, floor, furniture and things of random sizes, looks and places, none of them of
// sim_worlds; everyday objects of a catalogue on furniture, on the floor and under it.
// in: catalogue, random stream     out: a world of fixed bodies with the floor at z = 0 between (0, 0) and size_m;
// bodies are named so that sim_worlds/classes.yaml knows their class, objects begin with "storage_box_": otherprop
#pragma once

#include "core/random.hpp"
#include "training/furniture.hpp"
#include "world/catalogue.hpp"

namespace amiss::training {

struct TrainingRoom {
  world::World world;
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();
  std::size_t objects = 0;  // of the catalogue

  /// Whether a disc on the floor is clear of all that reaches below the robot's head.
  [[nodiscard]] bool is_free(const Eigen::Vector2d& p, double radius_m) const;
};

[[nodiscard]] TrainingRoom random_room(const world::Catalogue& catalogue, RandomStream& random);

}  // namespace amiss::training
