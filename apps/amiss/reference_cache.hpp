// The reference of a world, made once by a mapping run and kept.
#pragma once

#include <functional>

#include "mission/mapping_run.hpp"
#include "robot/model.hpp"
#include "score/alignment.hpp"
#include "settings.hpp"
#include "world/world.hpp"

namespace amiss::app {

/// What stands in the empty world, and how the robot's map lies in it (for the referee only).
struct PreparedReference {
  mission::Reference reference;
  Pose2<World, Map> T_world_map;
};

struct MappingInput {
  const world::World& world;
  const robot::Model& model;
  Pose2<World, Base> start;
  std::filesystem::path robot_file;  // the model's URDF
  std::uint64_t seed = 1;
};

struct MappingOutcome {
  mission::MappingReport report;
  score::LocalizationError error;  // after alignment
  Pose2<World, Map> T_world_map;
  std::size_t collisions = 0;
};

/// Runs the mapping run in the simulator; `sinks` may watch and stop it.
[[nodiscard]] MappingOutcome run_mapping(const MappingInput& input, const Settings& settings, bool threaded,
                                         mission::Sinks sinks);
/// map.yaml, map.pgm, mapped.ot, reference.ot and alignment.yaml (for the referee).
void save_prepared(const std::filesystem::path& folder, const mission::Reference& reference,
                   const Pose2<World, Map>& T_world_map);
[[nodiscard]] PreparedReference load_prepared(const std::filesystem::path& folder, const Settings& settings);

/// A hash of all that a reference is made from; its name in the cache.
[[nodiscard]] std::string reference_id(const MappingInput& input, Settings& settings);

/// From the cache, or made now (`announce` is told so first) and put there. Empty when it was stopped.
[[nodiscard]] std::optional<PreparedReference> cached_reference(const MappingInput& input, Settings& settings,
                                                                bool threaded, const mission::Sinks& sinks,
                                                                const std::function<void()>& announce);

}  // namespace amiss::app
