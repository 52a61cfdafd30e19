// The `objects` and `events` of a scenario file as a script.
#pragma once

#include "scenario/internal/yaml_reader.hpp"
#include "scenario/scenario_file.hpp"

namespace amiss::scenario::internal {

/// One object of `objects:`, there from the beginning.
[[nodiscard]] world::Event read_object(const YamlReader& item, const Vocabulary& vocabulary);
[[nodiscard]] world::Event read_event(const YamlReader& item, const Vocabulary& vocabulary);
[[nodiscard]] Pose2<World, Base> read_pose(const YamlReader& item);

/// Names of added bodies must be unique; events that wait for an object must name one that is added.
void check(const world::Script& script, const YamlReader& root);

}  // namespace amiss::scenario::internal
