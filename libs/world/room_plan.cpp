#include "world/room_plan.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>

#include "core/result.hpp"
#include "core/yaml_checks.hpp"

namespace amiss::world {
namespace {

constexpr int kMostObjects = 100;

const YAML::Node list_of(const std::filesystem::path& file, const YAML::Node& item, const char* key) {
  const YAML::Node node = item[key];
  if (node && node.IsSequence() && node.size() > 0) return node;
  throw InputError(yaml_place(file, node ? node : item) + key + " is not a list with at least one entry");
}

Pose2<amiss::World, Base> waypoint_of(const std::filesystem::path& file, const YAML::Node& node) {
  Pose2<amiss::World, Base> waypoint;
  double heading_deg = 0.0;
  const bool fine = node.IsSequence() && node.size() == 3 && YAML::convert<double>::decode(node[0], waypoint.x_m) &&
                    YAML::convert<double>::decode(node[1], waypoint.y_m) &&
                    YAML::convert<double>::decode(node[2], heading_deg) &&
                    std::isfinite(waypoint.x_m + waypoint.y_m + heading_deg);
  if (!fine) throw InputError(yaml_place(file, node) + "a waypoint is [x, y, heading in degrees]");
  waypoint.yaw_rad = wrap_angle(radians(heading_deg));
  return waypoint;
}

RoomPlan plan_of(const std::filesystem::path& file, const std::string& world, const YAML::Node& item) {
  check_yaml_keys(file, item, {"objects", "lift", "waypoints"}, {}, "{objects: [..], lift: .., waypoints: [..]}");
  RoomPlan plan;
  plan.world = world;
  for (const YAML::Node& node : list_of(file, item, "objects")) {
    int count = -1;
    if (!YAML::convert<int>::decode(node, count) || count < 0 || count > kMostObjects) {
      throw InputError(yaml_place(file, node) + "objects are whole numbers from 0 to 100");
    }
    plan.objects.push_back(count);
  }
  plan.lift_m = yaml_number(file, item, "lift", 0.0);
  for (const YAML::Node& node : list_of(file, item, "waypoints")) plan.waypoints.push_back(waypoint_of(file, node));
  return plan;
}

}  // namespace

std::vector<RoomPlan> load_room_plans(const std::filesystem::path& file) {
  const YAML::Node root = load_yaml(file);
  if (!root.IsMap()) throw InputError(file.string() + ":1: not a map; allowed is WORLD: {objects: [..], ..}");
  std::vector<RoomPlan> plans;
  for (const auto& pair : root) plans.push_back(plan_of(file, pair.first.as<std::string>(""), pair.second));
  return plans;
}

}  // namespace amiss::world
