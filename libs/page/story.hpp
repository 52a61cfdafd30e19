// A run as it can be told again from its timeline alone: the lines of timeline.jsonl (see events.hpp) -> what was where
// at which instant. Map frame, metres, radians, simulated seconds. What an event holds beyond that is left out.
// InputError naming the line that is no event of a run; runs of an earlier program that do not tell their place.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/floor_grid.hpp"
#include "page/events.hpp"

namespace amiss::page {

template <class Value>
struct Timed {
  double t_s = 0.0;
  Value value;
};

struct StoryPose {
  Pose2<Map, Base> believed, truth;
  robot::HeadState head;
};
struct StoryRegion {
  int id = 0;
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  bool examined = false, withdrawn = false;
  double z_low_m = 0.0, z_high_m = 0.0;
};
struct StoryObject {
  std::string name;
  Point<Map> place;
  bool found = false;
};
struct StoryView {
  int id = 0;
  Pose2<Map, Base> T_map_base;  // apex and direction
  double angle_rad = 0.0, height_m = 0.0;
  bool visited = false, dropped = false;
};
/// What the robot took for an object: an upright box.
struct StorySegment {
  Point<Map> centre;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
};
struct StoryVoxels {
  std::vector<mapping::Voxel> on, off;  // became occupied; ceased to be
};
struct StoryDifference {
  std::vector<mapping::Voxel> appeared, vanished;
};
struct StoryBody {
  std::string name, kind;
  std::optional<Transform<Map, Object>> T_map_body;  // none: it is gone
};
/// The robot: primitives where they are while the head looks straight ahead, and the axes that it turns about.
struct StoryRobot {
  enum class Part { kBody, kPan, kTilt };
  enum class Kind { kBox, kCylinder, kSphere };
  struct Shape {
    Part part = Part::kBody;
    Kind kind = Kind::kBox;
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // box: edges; cylinder: radius, height; sphere: radius
    Eigen::Isometry3d T_base_shape = Eigen::Isometry3d::Identity();
    Eigen::Vector3f rgb = Eigen::Vector3f::Zero();
  };
  struct Axis {
    Eigen::Vector3d point = Eigen::Vector3d::Zero(), direction = Eigen::Vector3d::UnitZ();  // base
  };
  std::vector<Shape> shapes;
  Axis pan, tilt;
};
struct Note {
  enum class Kind { kPlan, kDetected, kExamined, kFound, kCollision, kScript, kLog };
  Kind kind = Kind::kLog;
  std::string text;
};

struct Story {
  std::string world, method, outcome;
  std::uint64_t seed = 0;
  Place place;
  FloorGrid floor;
  double resolution_m = 0.0;              // of voxels
  std::vector<mapping::Voxel> reference;  // occupied
  StoryRobot robot;
  std::vector<Timed<StoryPose>> poses;
  std::vector<Timed<Slice>> pictures;  // of the camera, in colour
  std::vector<Timed<std::vector<StoryRegion>>> regions;
  std::vector<Timed<std::vector<StoryObject>>> objects;
  std::vector<Timed<std::vector<Eigen::Vector2d>>> paths;
  std::vector<Timed<StoryBody>> bodies;
  std::vector<Timed<StoryVoxels>> voxels;
  std::vector<Timed<StoryDifference>> differences;
  std::vector<Timed<std::vector<StoryView>>> views;
  std::vector<Timed<std::vector<StorySegment>>> segments;  // of one picture each
  std::vector<Timed<Note>> notes;
  double end_s = 0.0;  // of the last pose
};

[[nodiscard]] Story read_story(const std::vector<std::string>& lines);

/// The last that was told up to an instant; nullptr before the first.
template <class Value>
[[nodiscard]] const Value* latest(const std::vector<Timed<Value>>& list, double t_s) {
  const auto after =
      std::upper_bound(list.begin(), list.end(), t_s, [](double t, const Timed<Value>& e) { return t < e.t_s; });
  return after == list.begin() ? nullptr : &std::prev(after)->value;
}

/// What the robot's map held as occupied at an instant; sorted.
[[nodiscard]] std::vector<mapping::Voxel> voxels_at(const Story& story, double t_s);

/// The robot's primitives in its base frame, the head turned.
[[nodiscard]] std::vector<StoryRobot::Shape> shapes_at(const StoryRobot& robot, const robot::HeadState& head);

/// Between the two poses that were told around it.
[[nodiscard]] StoryPose pose_at(const Story& story, double t_s);

}  // namespace amiss::page
