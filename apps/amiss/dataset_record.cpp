#include "dataset_record.hpp"

#include <nlohmann/json.hpp>
#include <set>

#include "core/files.hpp"
#include "dataset_recorder.hpp"
#include "interrupt.hpp"

namespace amiss::app {

namespace {

constexpr double kLongestVisit = 1800.0;  // s, simulated
constexpr double kOnFloor_m = 0.1;        // an object whose lowest point is below this lies on the floor

/// All bodies by their numbers in instance images, with what was placed last.
std::vector<dataset::Instance> instance_table(const DatasetRoom& room, const sim::Visit& content,
                                              const world::Truth& truth) {
  std::vector<dataset::Instance> table;
  for (std::size_t i = 0; i < room.world.bodies.size(); ++i) {
    const std::string& name = room.world.bodies[i].name;
    table.push_back({static_cast<std::uint16_t>(i + 1), name, "", room.classes.class_of(name), false});
  }
  for (const world::ObjectTruth& object : truth.objects) {
    const auto placed = std::find_if(content.objects.begin(), content.objects.end(),
                                     [&](const sim::ScatteredObject& o) { return o.name == object.name; });
    if (placed == content.objects.end()) continue;
    table.push_back(
        {object.instance, object.name, placed->kind, SemanticClass::kOtherProp, object.bounds.min().z() < kOnFloor_m});
  }
  return table;
}

/// "base_link and chair_1", each pair once.
std::set<std::string> collided_with(const sim::Simulator& simulator) {
  std::set<std::string> pairs;
  for (const world::Collision& collision : simulator.collisions())
    pairs.insert(collision.link + " and " + collision.body);
  return pairs;
}

std::string report_json(const VisitToRecord& visit, const mission::TourReport& tour, const DatasetRecorder& recorder,
                        const sim::Simulator& simulator) {
  const score::LocalizationError error = score::localization_error(recorder.poses(), visit.prepared.T_world_map);
  const nlohmann::ordered_json json = {
      {"schema", 1},
      {"version", AMISS_VERSION},
      {"room", visit.room.plan.world},
      {"scene", visit.scene},
      {"seed", visit.seed},
      {"frames", recorder.frames()},
      {"waypoints", visit.room.plan.waypoints.size()},
      {"reached", tour.reached},
      {"left_out", tour.left_out},
      {"distance_m", tour.distance_m},
      {"simulated_s", seconds(tour.ended)},
      {"collisions", simulator.collisions().size()},
      {"collided_with", collided_with(simulator)},
      {"localization", {{"rmse_m", error.rmse_m}, {"rmse_rad", error.rmse_rad}, {"max_m", error.max_m}}}};
  return json.dump(2) + "\n";
}

}  // namespace

bool record_visit(const VisitToRecord& visit, const std::filesystem::path& folder) {
  const DatasetRoom& room = visit.room;
  Worker worker(false);
  sim::Simulator simulator(world::nudged(room.world, visit.content.nudges), room.model, visit.settings.run.simulator,
                           visit.seed, room.start, worker);
  for (const sim::ScatteredObject& object : visit.content.objects) {
    world::Body body = room.catalogue.at(object.kind).body;
    body.name = object.name;
    simulator.add_object(body, object.pose, object.kind);
  }
  mission::Params params = visit.settings.run.mission;
  params.perception.time_limit_s = kLongestVisit;
  DatasetRecorder recorder(folder, simulator, visit.prepared.T_world_map, params.perception.floor_clearance_m);
  if (visit.rawlog) recorder.also_as_rawlog();
  ObservedRobot robot(simulator, [&](const robot::Observation& seen) { recorder.observed(seen); });
  mission::Sinks sinks;
  sinks.stop = interrupted;
  sinks.step = [&](const mission::StepEvent& step) { recorder.believed(step); };
  sinks.frame = [&](const mission::FrameEvent& event) { recorder.framed(event); };

  // The map's frame is where the robot stood when the mapping run began, and it begins there again.
  std::vector<Pose2<Map, Base>> waypoints;
  const Pose2<Map, World> T_map_world{room.start.inverse().x_m, room.start.inverse().y_m, room.start.inverse().yaw_rad};
  for (const Pose2<World, Base>& waypoint : room.plan.waypoints) waypoints.push_back(T_map_world * waypoint);
  const mission::TourReport tour = mission::drive_tour(robot, visit.prepared.reference, Pose2<Map, Base>(), waypoints,
                                                       params, visit.settings.tour, visit.seed, sinks);
  if (!tour.complete) return false;
  dataset::save_instances(folder / "truth" / "instances.tsv", instance_table(room, visit.content, simulator.truth()));
  save_visit(folder / "truth", visit.content);
  save_atomically(folder / "recording.json", report_json(visit, tour, recorder, simulator));
  recorder.finish();
  return true;
}

}  // namespace amiss::app
