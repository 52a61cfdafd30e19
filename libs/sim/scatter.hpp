// Objects dropped on the floor of a world: catalogue, world, robot -> poses at which they rest, from a random stream.
// Each lies on the floor with free space above, apart from furniture, from its neighbours and from the robot's start;
// the robot can come near each of them, and none of them blocks a passage. Fewer than asked for is an InputError that
// says how many fit. Also scatter files: a YAML list of {object, x, y, [z], [yaw_deg], [roll_deg], [pitch_deg], [name]}
// [m, world frame].
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/params.hpp"
#include "core/random.hpp"
#include "robot/model.hpp"
#include "sim/free_space.hpp"
#include "world/catalogue.hpp"
#include "world/world.hpp"

namespace amiss::sim {

struct ScatterParams {
  double furniture_distance_m = 0.10;  // from the object's surface to the nearest static body
  double object_distance_m = 0.5;      // between the middles of two objects
  double start_distance_m = 0.8;       // from the robot's start
  double free_above_m = 1.2;           // nothing hangs over the object up to here
  double reach_m = 0.7;                // the robot's middle can come as near as this
  double robot_radius_m = 0.35;        // of the disc that needs a free path: 0.30 for driving and a cell of its map
  double drop_height_m = 0.05;
};
void describe(ParamTable& table, ScatterParams& params);

struct ScatteredObject {
  std::string kind;  // name in the catalogue
  std::string name;  // unique in the world
  Transform<amiss::World, Object> pose;
};

[[nodiscard]] std::vector<ScatteredObject> scatter(int count, const world::Catalogue& catalogue,
                                                   const world::World& world, const robot::Model& model,
                                                   const Pose2<amiss::World, Base>& start, RandomStream random,
                                                   const ScatterParams& params = {});

/// Errors name file and line; an unknown object comes with the nearest name of the catalogue. z left out: on the floor.
[[nodiscard]] std::vector<ScatteredObject> load_scatter(const std::filesystem::path& file,
                                                        const world::Catalogue& catalogue);
void save_scatter(const std::filesystem::path& file, const std::vector<ScatteredObject>& objects);

}  // namespace amiss::sim
