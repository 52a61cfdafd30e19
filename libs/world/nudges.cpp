#include "world/nudges.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "core/files.hpp"
#include "core/params.hpp"
#include "core/result.hpp"
#include "core/yaml_checks.hpp"

namespace amiss::world {
namespace {

std::size_t find_body(const World& world, const std::string& name) {
  const auto same = [&](const Body& body) { return body.name == name; };
  return static_cast<std::size_t>(std::find_if(world.bodies.begin(), world.bodies.end(), same) - world.bodies.begin());
}

/// "there is no body 'x' in the world; did you mean 'y'?"
std::string nobody(const World& world, const std::string& name) {
  std::vector<std::string> names;
  for (const Body& body : world.bodies) names.push_back(body.name);
  const std::string near = nearest_word(name, names);
  return "there is no body '" + name + "' in the world" + (near.empty() ? "" : "; did you mean '" + near + "'?");
}

}  // namespace

Transform<amiss::World, Object> nudged(const Transform<amiss::World, Object>& pose, const Nudge& nudge) {
  Transform<amiss::World, Object> moved;
  moved.T = Eigen::Translation3d(nudge.shift_m.x(), nudge.shift_m.y(), 0.0) * Eigen::Translation3d(pose.position()) *
            Eigen::AngleAxisd(nudge.yaw_rad, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(-pose.position()) *
            pose.T;
  return moved;
}

World nudged(World world, const std::vector<Nudge>& nudges) {
  for (const Nudge& nudge : nudges) {
    const std::size_t i = find_body(world, nudge.body);
    if (i == world.bodies.size()) throw ArgumentError(nobody(world, nudge.body));
    world.bodies[i].pose = nudged(world.bodies[i].pose, nudge);
  }
  return world;
}

std::vector<Nudge> load_nudges(const std::filesystem::path& file, const World& world) {
  const YAML::Node root = load_yaml(file);
  if (!root.IsSequence()) throw InputError(file.string() + ":1: not a list; allowed is - {body: NAME, x: .., y: ..}");
  std::vector<Nudge> nudges;
  for (const YAML::Node& item : root) {
    check_yaml_keys(file, item, {"body", "x", "y", "yaw_deg"}, {}, "{body: NAME, x: .., y: .., yaw_deg: ..}");
    Nudge nudge;
    nudge.body = yaml_text(file, item, "body");
    if (find_body(world, nudge.body) == world.bodies.size()) {
      throw InputError(yaml_place(file, item["body"]) + nobody(world, nudge.body));
    }
    nudge.shift_m = {yaml_number(file, item, "x", 0.0), yaml_number(file, item, "y", 0.0)};
    nudge.yaw_rad = radians(yaml_number(file, item, "yaw_deg", 0.0));
    nudges.push_back(std::move(nudge));
  }
  return nudges;
}

void save_nudges(const std::filesystem::path& file, const std::vector<Nudge>& nudges) {
  std::string text;
  for (const Nudge& nudge : nudges) {
    text += "- {body: " + yaml_quoted(nudge.body) + ", x: " + yaml_exact(nudge.shift_m.x()) +
            ", y: " + yaml_exact(nudge.shift_m.y()) + ", yaw_deg: " + yaml_exact(degrees(nudge.yaw_rad)) + "}\n";
  }
  save_atomically(file, text.empty() ? "[]\n" : text);
}

}  // namespace amiss::world
