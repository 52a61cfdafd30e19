#include "scenario_random.hpp"

#include <algorithm>
#include <cmath>

#include "resources.hpp"
#include "robot/model.hpp"
#include "scenario/random_scenario.hpp"
#include "scenario/scenario_file.hpp"
#include "scenario_run.hpp"
#include "settings.hpp"
#include "sim/scatter.hpp"
#include "start_pose.hpp"
#include "world/catalogue.hpp"
#include "world/loader.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr double kCell_m = 0.05;
constexpr double kRoom_m = 0.4;       // round a robot that is put down
constexpr int kEvery = 4;             // cells between two places
constexpr double kApart_m = 0.7;      // from an object to a robot that is put down
constexpr double kDoorApart_m = 1.2;  // from the middle of a frame to the start

/// Places that are connected with the start.
std::vector<Eigen::Vector2d> standing_places(const world::World& world, const robot::Model& model,
                                             const Pose2<World, Base>& start) {
  const FloorGrid plan = sim::floor_plan(world, kCell_m, sim::kLowestObstacle_m, model.height_m, true);
  const FloorGrid room = sim::standing_room(plan, kRoom_m);
  const std::vector<int> areas = sim::connected_areas(room);
  const int own = areas.at(room.index(room.cell_at(start.position())));
  std::vector<Eigen::Vector2d> places;
  for (int y = 0; y < room.height(); y += kEvery) {
    for (int x = 0; x < room.width(); x += kEvery) {
      if (own == 0 || areas[room.index({x, y})] != own) continue;
      const Eigen::Vector2d p = room.centre_of({x, y});
      places.emplace_back(std::round(p.x() * 100.0) / 100.0, std::round(p.y() * 100.0) / 100.0);
    }
  }
  return places;
}

/// The start, from which objects keep their distance, where nothing else is left.
std::vector<Eigen::Vector2d> apart_from(const std::vector<world::AddBody>& objects, std::vector<Eigen::Vector2d> places,
                                        const Eigen::Vector2d& start_m) {
  std::erase_if(places, [&](const Eigen::Vector2d& p) {
    return std::any_of(objects.begin(), objects.end(), [&](const world::AddBody& o) {
      return std::hypot(o.place.x_m - p.x(), o.place.y_m - p.y()) < kApart_m;
    });
  });
  if (places.empty()) places.push_back(start_m);
  return places;
}

/// By their names: door_leaf_N belongs into door_frame_N.
void add_what_moves(const world::World& world, scenario::Stage& stage) {
  const auto apart = [&](const world::Body& body, double least_m) {
    return (body.pose.T.translation().head<2>() - stage.start_m).norm() >= least_m;
  };
  const std::string leaf = "door_leaf", frame = "door_frame";
  for (const world::Body& body : world.bodies) {
    if (body.name.rfind("chair", 0) == 0 && apart(body, kApart_m)) stage.chairs.push_back(body.name);
    if (body.name.rfind(leaf, 0) != 0) continue;
    const std::string wanted = frame + body.name.substr(leaf.size());
    for (const world::Body& other : world.bodies) {
      if (other.name == wanted && apart(other, kDoorApart_m)) stage.doors.push_back({body.name, other.name});
    }
  }
}

std::vector<world::AddBody> on_the_floor(const std::vector<sim::ScatteredObject>& scattered) {
  std::vector<world::AddBody> bodies;
  for (const sim::ScatteredObject& object : scattered) {
    const Eigen::Vector3d at = object.pose.T.translation();
    const world::Place place{std::round(at.x() * 100.0) / 100.0, std::round(at.y() * 100.0) / 100.0, {}, 0.0};
    bodies.push_back({object.kind, object.name, place});
  }
  return bodies;
}

}  // namespace

std::vector<scenario::Scenario> random_scenarios(const RandomScenarios& wanted) {
  const Resources resources = find_resources();
  const Settings settings = load_settings("", {});
  const fs::path file = fs::absolute(find_world(resources, wanted.world));
  const world::World world = world::load_world(file, settings.world);
  const robot::Model model = robot::load_model(resources.robot);
  const Pose2<World, Base> start = start_pose(world, model, {});
  const world::Catalogue catalogue = world::load_catalogue({resources.objects}, settings.world);
  const std::vector<Eigen::Vector2d> places = standing_places(world, model, start);
  scenario::Stage stage{fs::exists(wanted.world) ? file.string() : wanted.world, {}, {}, start.position(), {}, {}};
  add_what_moves(world, stage);

  std::vector<scenario::Scenario> scenarios;
  for (int number = 1; number <= wanted.count; ++number) {
    RandomStream random(wanted.seed, "random_scenarios/objects/" + std::to_string(number));
    stage.objects =
        on_the_floor(sim::scatter(scenario::kMostObjects, catalogue, world, model, start, random, settings.scatter));
    stage.standing_m = apart_from(stage.objects, places, start.position());
    scenarios.push_back(scenario::random_scenario(stage, wanted.seed, number));
  }
  return scenarios;
}

fs::path save_random_scenario(scenario::Scenario scenario, const fs::path& folder) {
  fs::create_directories(folder);
  if (fs::path(scenario.world).is_absolute()) {
    scenario.world = fs::relative(scenario.world, folder).generic_string();
  }
  const fs::path file = folder / (scenario.name + ".yaml");
  scenario::save_scenario(file, scenario, vocabulary_of(find_resources()));
  return file;
}

}  // namespace amiss::app
