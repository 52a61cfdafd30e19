#include "dataset_rooms.hpp"

#include <algorithm>
#include <array>

#include "core/result.hpp"
#include "start_pose.hpp"

namespace amiss::app {

namespace {

constexpr double kTorsoPerLift = 0.5;  // the torso follows the arm at half of its lift
constexpr double kEyeTilt = -radians(35.0);

/// Where the camera is while the robot looks round at its waypoints.
std::vector<Point<World>> eyes_of(const world::RoomPlan& plan, const robot::Model& model, double pan_rad) {
  std::vector<Point<World>> eyes;
  for (const Pose2<World, Base>& waypoint : plan.waypoints) {
    for (const double pan : {-pan_rad, 0.0, pan_rad}) {
      eyes.push_back({(waypoint.lift() * model.T_base_camera({pan, kEyeTilt})).position()});
    }
  }
  return eyes;
}

}  // namespace

ParamTable DatasetSettings::table() {
  ParamTable table = run.table();
  sim::describe(table, visits);
  mission::describe(table, tour);
  return table;
}

DatasetSettings load_dataset_settings(const std::string& params_file, const std::vector<std::string>& overrides) {
  DatasetSettings settings;
  ParamTable table = settings.table();
  if (!params_file.empty()) table.load_file(params_file);
  for (const std::string& assignment : overrides) table.set_override(assignment);
  settings.visits.scatter = settings.run.scatter;
  return settings;
}

std::vector<world::RoomPlan> chosen_rooms(const Resources& resources, const std::vector<std::string>& names,
                                          std::optional<int> visits) {
  std::vector<world::RoomPlan> chosen;
  std::vector<std::string> known;
  for (world::RoomPlan& plan : world::load_room_plans(resources.worlds / "dataset.yaml")) {
    known.push_back(plan.world);
    if (!names.empty() && std::find(names.begin(), names.end(), plan.world) == names.end()) continue;
    if (visits) plan.objects.resize(std::min(plan.objects.size(), static_cast<std::size_t>(*visits)));
    chosen.push_back(std::move(plan));
  }
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string near = nearest_word(name, known);
    throw ArgumentError("--rooms " + name + ": there is no such room" +
                        (near.empty() ? "; see sim_worlds/dataset.yaml" : "; did you mean '" + near + "'?"));
  }
  return chosen;
}

DatasetRoom load_room(const Resources& resources, const world::RoomPlan& plan, const DatasetSettings& settings) {
  DatasetRoom room;
  room.plan = plan;
  room.world = world::load_world(find_world(resources, plan.world), settings.run.world);
  room.classes = world::class_table_beside(room.world);
  room.catalogue = world::load_catalogue({resources.objects}, settings.run.world);
  room.model = robot::load_model(resources.robot);
  room.model.neutral["arm_lift_joint"] = plan.lift_m;
  room.model.height_m += kTorsoPerLift * plan.lift_m;
  room.start = start_pose(room.world, room.model, {});
  return room;
}

std::vector<sim::Visit> place_objects(const DatasetRoom& room, const DatasetSettings& settings, std::uint64_t seed) {
  const sim::VisitedRoom visited{room.world, room.classes, room.catalogue, room.model, room.start,
                                 eyes_of(room.plan, room.model, settings.tour.pan_rad)};
  return sim::make_visits(visited, room.plan.objects, settings.visits,
                          RandomStream(seed, "dataset/" + room.plan.world + "/visits"));
}

void save_visit(const std::filesystem::path& folder, const sim::Visit& visit) {
  std::filesystem::create_directories(folder);
  world::save_nudges(folder / "nudges.yaml", visit.nudges);
  sim::save_scatter(folder / "objects.yaml", visit.objects);
}

sim::Visit load_visit(const std::filesystem::path& folder, const DatasetRoom& room) {
  return {world::load_nudges(folder / "nudges.yaml", room.world),
          sim::load_scatter(folder / "objects.yaml", room.catalogue)};
}

std::string scene_name(std::size_t visit) { return "scene" + std::to_string(visit + 1); }

}  // namespace amiss::app
