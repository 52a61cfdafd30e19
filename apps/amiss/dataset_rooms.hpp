// The rooms of a data set: what is needed to place objects in them and to record them.
// dataset.yaml and worlds -> rooms; seed -> placements, as files of a folder, and back.
#pragma once

#include "mission/tour.hpp"
#include "resources.hpp"
#include "settings.hpp"
#include "sim/visits.hpp"
#include "world/catalogue.hpp"
#include "world/room_plan.hpp"

namespace amiss::app {

/// Parameters of a run, and of what is placed and how it is recorded.
struct DatasetSettings {
  Settings run;
  sim::VisitsParams visits;
  mission::TourParams tour;

  DatasetSettings() {
    run.scatter = visits.scatter;
    run.simulator.camera_period_s = 0.4;  // a room is a few hundred megabytes
  }
  [[nodiscard]] ParamTable table();
};
[[nodiscard]] DatasetSettings load_dataset_settings(const std::string& params_file,
                                                    const std::vector<std::string>& overrides);

/// The plans of these rooms (all where none is named), each with at most `visits` visits. ArgumentError with the nearest
/// name for an unknown room.
[[nodiscard]] std::vector<world::RoomPlan> chosen_rooms(const Resources& resources,
                                                        const std::vector<std::string>& names,
                                                        std::optional<int> visits);

struct DatasetRoom {
  world::RoomPlan plan;
  world::World world;  // tidy
  world::ClassTable classes;
  world::Catalogue catalogue;
  robot::Model model;  // with its torso lifted
  Pose2<World, Base> start;
};
[[nodiscard]] DatasetRoom load_room(const Resources& resources, const world::RoomPlan& plan,
                                    const DatasetSettings& settings);

[[nodiscard]] std::vector<sim::Visit> place_objects(const DatasetRoom& room, const DatasetSettings& settings,
                                                    std::uint64_t seed);

/// nudges.yaml and objects.yaml of one visit.
void save_visit(const std::filesystem::path& folder, const sim::Visit& visit);
[[nodiscard]] sim::Visit load_visit(const std::filesystem::path& folder, const DatasetRoom& room);

/// "scene1" is the tidy room, "scene2" the first visit.
[[nodiscard]] std::string scene_name(std::size_t visit);

}  // namespace amiss::app
