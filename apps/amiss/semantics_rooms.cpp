#include "semantics_rooms.hpp"

#include "dataset_rooms.hpp"
#include "semantics/parallel.hpp"
#include "world/nudges.hpp"

namespace amiss::app {

namespace {

/// Looking to both sides, low and high, at every waypoint.
std::vector<Transform<World, Camera>> views_of(const DatasetRoom& room, const mission::TourParams& tour) {
  std::vector<Transform<World, Camera>> views;
  for (const Pose2<World, Base>& waypoint : room.plan.waypoints) {
    for (const double tilt : {tour.low_tilt_rad, tour.high_tilt_rad}) {
      for (const double pan : {-tour.pan_rad, 0.0, tour.pan_rad}) {
        views.push_back(waypoint.lift() * room.model.T_base_camera({pan, tilt}));
      }
    }
  }
  return views;
}

/// With the objects of a visit, which are otherprop whatever they are called.
training::LabelledCloud sampled_room(const DatasetRoom& room, const DatasetSettings& settings, std::uint64_t seed) {
  const sim::Visit visit = place_objects(room, settings, seed).front();
  world::World world = world::nudged(room.world, visit.nudges);
  for (const sim::ScatteredObject& object : visit.objects) {
    world.bodies.push_back(room.catalogue.at(object.kind).body);
    world.bodies.back().name = "object_" + object.name;
    world.bodies.back().pose = object.pose;
  }
  std::vector<world::ClassTable::Row> rows = room.classes.rows();
  rows.push_back({"object", SemanticClass::kOtherProp});
  RandomStream random(seed, "semantics/" + room.plan.world);
  return training::sampled_cloud(world, world::ClassTable(rows), views_of(room, settings.tour), {}, random);
}

}  // namespace

std::vector<RoomSample> sampled_rooms(const std::vector<std::string>& names, std::uint64_t seed, int threads) {
  const Resources resources = find_resources();
  const DatasetSettings settings = load_dataset_settings("", {});
  const std::vector<world::RoomPlan> plans = chosen_rooms(resources, names, 1);
  std::vector<RoomSample> samples(plans.size());
  semantics::in_parallel(plans.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      samples[i] = {plans[i].world, sampled_room(load_room(resources, plans[i], settings), settings, seed)};
    }
  });
  return samples;
}

}  // namespace amiss::app
