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
};
struct StoryObject {
  std::string name;
  Point<Map> place;
  bool found = false;
};
struct StoryBody {
  std::string name, kind;
  std::optional<Transform<Map, Object>> T_map_body;  // none: it is gone
};
struct Note {
  enum class Kind { kPlan, kDetected, kExamined, kFound, kCollision, kLog };
  Kind kind = Kind::kLog;
  std::string text;
};

struct Story {
  std::string world, method, outcome;
  std::uint64_t seed = 0;
  Place place;
  FloorGrid floor;
  std::vector<Timed<StoryPose>> poses;
  std::vector<Timed<Slice>> pictures;  // of the camera, in colour
  std::vector<Timed<std::vector<StoryRegion>>> regions;
  std::vector<Timed<std::vector<StoryObject>>> objects;
  std::vector<Timed<std::vector<Eigen::Vector2d>>> paths;
  std::vector<Timed<StoryBody>> bodies;
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

/// Between the two poses that were told around it.
[[nodiscard]] StoryPose pose_at(const Story& story, double t_s);

}  // namespace amiss::page
