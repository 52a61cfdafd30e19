#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "core/files.hpp"
#include "core/params.hpp"
#include "core/result.hpp"
#include "sim/physics.hpp"
#include "sim/scatter.hpp"

namespace amiss::sim {
namespace {

constexpr std::size_t kMaxBytes = 1U << 20U;
constexpr double kFarthest_m = 1000.0;

std::string where(const std::filesystem::path& file, const YAML::Node& node) {
  return file.string() + ":" + std::to_string(std::max(0, node.Mark().line) + 1) + ": ";
}

double number_of(const std::filesystem::path& file, const YAML::Node& item, const std::string& key, double fallback) {
  const YAML::Node node = item[key];
  if (!node) return fallback;
  double value = 0.0;
  const bool is_number = node.IsScalar() && YAML::convert<double>::decode(node, value) && std::isfinite(value);
  if (!is_number || std::abs(value) > kFarthest_m) {
    throw InputError(where(file, node) + key + " is not a number from -1000 to 1000");
  }
  return value;
}

std::string text_of(const std::filesystem::path& file, const YAML::Node& item, const std::string& key) {
  const YAML::Node node = item[key];
  if (node && node.IsScalar() && !node.Scalar().empty()) return node.Scalar();
  throw InputError(where(file, node ? node : item) + key + " is missing or empty; a name is needed");
}

void check_keys(const std::filesystem::path& file, const YAML::Node& item) {
  static const std::vector<std::string> kKnown{"object", "name", "x", "y", "z", "yaw_deg", "roll_deg", "pitch_deg"};
  if (!item.IsMap()) throw InputError(where(file, item) + "not a map; allowed is {object: NAME, x: .., y: ..}");
  for (const auto& pair : item) {
    const std::string key = pair.first.IsScalar() ? pair.first.Scalar() : "?";
    if (std::find(kKnown.begin(), kKnown.end(), key) != kKnown.end()) continue;
    const std::string nearest = nearest_word(key, kKnown);
    throw InputError(where(file, pair.first) + "unknown key '" + key + "'" +
                     (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") +
                     " Allowed: object, name, x, y, z, yaw_deg, roll_deg, pitch_deg");
  }
  for (const char* key : {"x", "y"}) {
    if (!item[key]) throw InputError(where(file, item) + key + " is missing; a number is needed");
  }
}

const world::CatalogueEntry& entry_of(const std::filesystem::path& file, const YAML::Node& item,
                                      const world::Catalogue& catalogue) {
  const std::string kind = text_of(file, item, "object");
  if (const world::CatalogueEntry* entry = catalogue.find(kind)) return *entry;
  std::vector<std::string> names;
  for (const world::CatalogueEntry& entry : catalogue.entries) names.push_back(entry.name);
  const std::string nearest = nearest_word(kind, names);
  throw InputError(where(file, item["object"]) + "no object '" + kind + "' in the catalogue" +
                   (nearest.empty() ? "; see `amiss objects`" : "; did you mean '" + nearest + "'?"));
}

Transform<amiss::World, Object> pose_of(const std::filesystem::path& file, const YAML::Node& item,
                                        const world::Body& body) {
  const auto angle = [&](const char* key, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(radians(number_of(file, item, key, 0.0)), axis);
  };
  Transform<amiss::World, Object> pose;
  pose.T.linear() = (angle("yaw_deg", Eigen::Vector3d::UnitZ()) * angle("pitch_deg", Eigen::Vector3d::UnitY()) *
                     angle("roll_deg", Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
  world::Body turned = body;
  turned.is_static = false;
  turned.pose = pose;
  Physics alone(world::World{});
  const Eigen::AlignedBox3d box = alone.bounds(alone.add(turned));
  const double on_floor_m = box.isEmpty() ? 0.0 : -box.min().z();
  pose.T.translation() = Eigen::Vector3d(number_of(file, item, "x", 0.0), number_of(file, item, "y", 0.0),
                                         number_of(file, item, "z", on_floor_m));
  return pose;
}

YAML::Node parsed(const std::filesystem::path& file) {
  try {
    return YAML::Load(load_bytes(file, kMaxBytes));
  } catch (const YAML::Exception& error) {
    throw InputError(file.string() + ":" + std::to_string(std::max(0, error.mark.line) + 1) +
                     ": not YAML: " + error.msg);
  }
}

std::string exact(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// Single quotes of YAML, in which only the quote itself is special.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

}  // namespace

std::vector<ScatteredObject> load_scatter(const std::filesystem::path& file, const world::Catalogue& catalogue) {
  const YAML::Node root = parsed(file);
  std::vector<ScatteredObject> out;
  if (!root.IsSequence()) {
    throw InputError(file.string() + ":1: not a list; allowed is - {object: NAME, x: .., y: ..} for each object");
  }
  std::set<std::string> names;
  for (const YAML::Node& item : root) {
    check_keys(file, item);
    const world::CatalogueEntry& entry = entry_of(file, item, catalogue);
    std::string name = item["name"] ? text_of(file, item, "name") : entry.name;
    if (item["name"] && names.count(name) != 0) {
      throw InputError(where(file, item["name"]) + "the name '" + name + "' is there twice; names are unique");
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
    text += "- {object: " + quoted(object.kind) + ", name: " + quoted(object.name) + ", x: " + exact(p.x()) +
            ", y: " + exact(p.y()) + ", z: " + exact(p.z()) + ", yaw_deg: " + exact(degrees(yaw)) +
            ", pitch_deg: " + exact(degrees(pitch)) + ", roll_deg: " + exact(degrees(roll)) + "}\n";
  }
  save_atomically(file, text.empty() ? "[]\n" : text);
}

}  // namespace amiss::sim
