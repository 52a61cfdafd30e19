#include "page/internal/story_values.hpp"

#include "core/base64.hpp"
#include "core/result.hpp"

namespace amiss::page {

using Json = nlohmann::json;

namespace {

StoryRobot::Axis axis_of(const Json& json) {
  if (json.is_null()) return {};  // a head that does not turn
  const Eigen::Vector3d direction = vector_of(json.at("axis"));
  if (!(direction.norm() > 0.9 && direction.norm() < 1.1)) throw InputError("an axis of the robot is no direction");
  return {vector_of(json.at("p")), direction.normalized()};
}

template <class Value>
Value one_of(const Json& name, std::initializer_list<std::pair<const char*, Value>> known) {
  for (const auto& [allowed, value] : known) {
    if (name == allowed) return value;
  }
  throw InputError("a link of the robot is of no known kind: " + name.dump());
}

}  // namespace

double number(const Json& list, std::size_t i) { return list.at(i).get<double>(); }

FloorGrid floor_of(const Json& json) {
  constexpr int kMostCells = 20000;
  constexpr double kFarthest_m = 1e5, kLargestCell_m = 10.0;
  const int width = json.at("width"), height = json.at("height");
  const double resolution_m = json.at("resolution");
  const std::string bytes = from_base64(json.at("cells").get_ref<const std::string&>());
  const bool good = width >= 0 && height >= 0 && width < kMostCells && height < kMostCells && resolution_m > 0.0;
  const std::size_t cells = good ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0;
  if (!good || bytes.size() != (cells + 3) / 4) throw InputError("the floor has another size than it says");
  const Eigen::Vector2d origin = point_of(json.at("origin"));
  if (!(origin.cwiseAbs().maxCoeff() < kFarthest_m) || !(resolution_m < kLargestCell_m))
    throw InputError("the floor is farther away than 100 km, or its cells are larger than 10 m");
  FloorGrid floor(resolution_m, origin, width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = floor.index({x, y});
      const unsigned value = static_cast<unsigned char>(bytes[i / 4]) >> (2 * (i % 4)) & 3U;
      if (value > 2) throw InputError("a cell of the floor is neither unknown, free nor occupied");
      floor.set({x, y}, static_cast<Occupancy>(value));
    }
  }
  return floor;
}

Eigen::Isometry3d pose_of(const Json& p) {
  const Eigen::Quaterniond turn(number(p, 6), number(p, 3), number(p, 4), number(p, 5));
  if (!(turn.norm() > 0.9 && turn.norm() < 1.1)) throw InputError("a pose is no rigid motion");
  return Eigen::Translation3d(number(p, 0), number(p, 1), number(p, 2)) * turn.normalized();
}

Pose2<Map, Base> pose2_of(const Json& p) { return {number(p, 0), number(p, 1), number(p, 2)}; }
Eigen::Vector2d point_of(const Json& p) { return {number(p, 0), number(p, 1)}; }
Eigen::Vector3d vector_of(const Json& p) { return {number(p, 0), number(p, 1), number(p, 2)}; }

std::vector<mapping::Voxel> voxels_of(const Json& text) {
  const std::string bytes = from_base64(text.get_ref<const std::string&>());
  if (bytes.size() % 6 != 0) throw InputError("voxels are three numbers of two bytes each");
  const auto index = [&](std::size_t i) -> int {
    const auto low = static_cast<unsigned char>(bytes[i]), high = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(low | high << 8));
  };
  std::vector<mapping::Voxel> voxels;
  voxels.reserve(bytes.size() / 6);
  for (std::size_t i = 0; i < bytes.size(); i += 6) voxels.push_back({index(i), index(i + 2), index(i + 4)});
  return voxels;
}

StoryRobot robot_of(const Json& json) {
  using Part = StoryRobot::Part;
  using Kind = StoryRobot::Kind;
  StoryRobot robot;
  robot.pan = axis_of(json.at("pan"));
  robot.tilt = axis_of(json.at("tilt"));
  for (const Json& link : json.at("links")) {
    const Part part =
        one_of<Part>(link.at("part"), {{"body", Part::kBody}, {"pan", Part::kPan}, {"tilt", Part::kTilt}});
    for (const Json& shape : link.at("shapes")) {
      const Kind kind = one_of<Kind>(shape.at("kind"),
                                     {{"box", Kind::kBox}, {"cylinder", Kind::kCylinder}, {"sphere", Kind::kSphere}});
      robot.shapes.push_back({part, kind, vector_of(shape.at("size")), pose_of(shape.at("pose")),
                              vector_of(shape.at("rgb")).cast<float>()});
    }
  }
  return robot;
}

}  // namespace amiss::page
