#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/files.hpp"
#include "core/params.hpp"
#include "core/result.hpp"
#include "core/yaml_checks.hpp"
#include "sim/internal/falling.hpp"
#include "sim/scatter.hpp"

namespace amiss::sim {
namespace {

void check_keys(const std::filesystem::path& file, const YAML::Node& item) {
  check_yaml_keys(file, item, {"object", "name", "x", "y", "z", "yaw_deg", "roll_deg", "pitch_deg"}, {"x", "y"},
                  "{object: NAME, x: .., y: ..}");
}

const world::CatalogueEntry& entry_of(const std::filesystem::path& file, const YAML::Node& item,
                                      const world::Catalogue& catalogue) {
  const std::string kind = yaml_text(file, item, "object");
  if (const world::CatalogueEntry* entry = catalogue.find(kind)) return *entry;
  std::vector<std::string> names;
  for (const world::CatalogueEntry& entry : catalogue.entries) names.push_back(entry.name);
  const std::string nearest = nearest_word(kind, names);
  throw InputError(yaml_place(file, item["object"]) + "no object '" + kind + "' in the catalogue" +
                   (nearest.empty() ? "; see `amiss objects`" : "; did you mean '" + nearest + "'?"));
}

Transform<amiss::World, Object> pose_of(const std::filesystem::path& file, const YAML::Node& item,
                                        const world::Body& body) {
  const auto angle = [&](const char* key, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(radians(yaml_number(file, item, key, 0.0)), axis);
  };
  Transform<amiss::World, Object> pose;
  pose.T.linear() = (angle("yaw_deg", Eigen::Vector3d::UnitZ()) * angle("pitch_deg", Eigen::Vector3d::UnitY()) *
                     angle("roll_deg", Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
  const Eigen::AlignedBox3d box = internal::turned(body, pose.T).bounds;
  const double on_floor_m = box.isEmpty() ? 0.0 : -box.min().z();
  pose.T.translation() = Eigen::Vector3d(yaml_number(file, item, "x", 0.0), yaml_number(file, item, "y", 0.0),
                                         yaml_number(file, item, "z", on_floor_m));
  return pose;
}

}  // namespace

std::vector<ScatteredObject> load_scatter(const std::filesystem::path& file, const world::Catalogue& catalogue) {
  const YAML::Node root = load_yaml(file);
  std::vector<ScatteredObject> out;
  if (!root.IsSequence()) {
    throw InputError(file.string() + ":1: not a list; allowed is - {object: NAME, x: .., y: ..} for each object");
  }
  std::set<std::string> names;
  for (const YAML::Node& item : root) {
    check_keys(file, item);
    const world::CatalogueEntry& entry = entry_of(file, item, catalogue);
    std::string name = item["name"] ? yaml_text(file, item, "name") : entry.name;
    if (item["name"] && names.count(name) != 0) {
      throw InputError(yaml_place(file, item["name"]) + "the name '" + name + "' is there twice; names are unique");
    }
    for (int i = 2; names.count(name) != 0; ++i) name = entry.name + "_" + std::to_string(i);
    names.insert(name);
    out.push_back({entry.name, name, pose_of(file, item, entry.body)});
  }
  return out;
}

void save_scatter(const std::filesystem::path& file, const std::vector<ScatteredObject>& objects) {
  std::string text;
  for (const ScatteredObject& object : objects) {
    const Eigen::Matrix3d& R = object.pose.T.linear();
    const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
    const double yaw = std::atan2(R(1, 0), R(0, 0)), roll = std::atan2(R(2, 1), R(2, 2));
    const Eigen::Vector3d p = object.pose.position();
    text += "- {object: " + yaml_quoted(object.kind) + ", name: " + yaml_quoted(object.name) + ", x: " + yaml_exact(p.x()) +
            ", y: " + yaml_exact(p.y()) + ", z: " + yaml_exact(p.z()) + ", yaw_deg: " + yaml_exact(degrees(yaw)) +
            ", pitch_deg: " + yaml_exact(degrees(pitch)) + ", roll_deg: " + yaml_exact(degrees(roll)) + "}\n";
  }
  save_atomically(file, text.empty() ? "[]\n" : text);
}

}  // namespace amiss::sim
