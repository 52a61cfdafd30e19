#include "page/story.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/result.hpp"
#include "page/internal/story_values.hpp"

namespace amiss::page {

namespace {

using Json = nlohmann::json;

class Teller {
 public:
  void tell(const Json& e) {
    t_ = e.at("t");
    const std::string kind = e.at("e");
    if (kind == "start") start(e);
    if (kind == "pose") pose(e);
    if (kind == "frame") story.pictures.push_back({t_, {e.at("colour").at(0), e.at("colour").at(1)}});
    if (kind == "regions") regions(e);
    if (kind == "objects") objects(e);
    if (kind == "bodies") bodies(e);
    if (kind == "path") path(e);
    if (kind == "views") views(e);
    if (kind == "voxels") story.voxels.push_back({t_, {voxels_of(e.at("on")), voxels_of(e.at("off"))}});
    if (kind == "difference")
      story.differences.push_back({t_, {voxels_of(e.at("appeared")), voxels_of(e.at("vanished"))}});
    if (kind == "plan") {
      const int number = e.at("number");
      note(Note::Kind::kPlan, fmt::format("plan {} of {} steps", number, e.at("steps").size()));
    }
    if (kind == "examined") examined(e);
    if (kind == "collision") note(Note::Kind::kCollision, "touched " + e.at("body").get<std::string>());
    if (kind == "script") note(Note::Kind::kScript, e.at("text"));
    if (kind == "log") note(Note::Kind::kLog, e.at("text"));
    if (kind == "end") story.outcome = e.at("report").value("outcome", "");
  }
  Story story;

 private:
  void note(Note::Kind kind, std::string text) { story.notes.push_back({t_, {kind, std::move(text)}}); }
  void start(const Json& e) {
    if (!e.contains("place"))
      throw InputError("does not say where the run took place, since an earlier amiss made it; a newer run is needed");
    story.world = e.at("world");
    story.method = e.at("method");
    story.seed = e.at("seed");
    const Json& place = e["place"];
    story.place = {place.at("world"), place.at("robot"), {pose_of(place.at("T_world_map"))}};
    story.floor = floor_of(e.at("floor"));
    story.resolution_m = e.at("resolution");
    if (!(story.resolution_m > 0.0)) throw InputError("the resolution of the voxels has to be above 0");
    story.reference = voxels_of(e.at("reference"));
    story.robot = robot_of(e.at("robot"));
  }
  void pose(const Json& e) {
    story.poses.push_back(
        {t_, {pose2_of(e.at("p")), pose2_of(e.at("true")), {number(e.at("head"), 0), number(e.at("head"), 1)}}});
    story.end_s = t_;
  }
  void regions(const Json& e) {
    std::vector<StoryRegion> list;
    for (const Json& r : e.at("list")) {
      const std::string state = r.at("state");
      list.push_back({r.at("id"), point_of(r.at("p")), r.at("radius"), state == "examined", state == "withdrawn",
                      number(r.at("z"), 0), number(r.at("z"), 1)});
      if (known_.insert(list.back().id).second)
        note(Note::Kind::kDetected, fmt::format("region {} detected", list.back().id));
    }
    story.regions.push_back({t_, std::move(list)});
  }
  void objects(const Json& e) {
    std::vector<StoryObject> list;
    for (const Json& o : e.at("list")) {
      list.push_back({o.at("name"), {vector_of(o.at("p"))}, o.at("found")});
      if (list.back().found && found_.insert(list.back().name).second)
        note(Note::Kind::kFound, "found " + list.back().name);
    }
    story.objects.push_back({t_, std::move(list)});
  }
  void bodies(const Json& e) {
    for (const Json& b : e.at("list")) {
      story.bodies.push_back({t_, {b.at("name"), b.at("kind"), Transform<Map, Object>{pose_of(b.at("pose"))}}});
    }
    for (const Json& name : e.at("gone")) story.bodies.push_back({t_, {name, "", std::nullopt}});
  }
  void path(const Json& e) {
    std::vector<Eigen::Vector2d> points;
    for (const Json& p : e.at("points")) points.push_back(point_of(p));
    story.paths.push_back({t_, std::move(points)});
  }
  void examined(const Json& e) {
    const int region = e.at("region");
    const std::string what = region == 0 ? "picture segmented" : fmt::format("region {} examined", region);
    note(Note::Kind::kExamined, fmt::format("{}: {} segments", what, e.at("segments").size()));
    std::vector<StorySegment> list;
    for (const Json& s : e.at("segments"))
      list.push_back({{vector_of(s.at("p"))}, vector_of(s.at("size")), s.at("yaw")});
    story.segments.push_back({t_, std::move(list)});
  }
  void views(const Json& e) {
    std::vector<StoryView> list;
    for (const Json& v : e.at("list")) {
      const std::string state = v.at("state");
      list.push_back(
          {v.at("id"), pose2_of(v.at("p")), v.at("angle"), v.at("height"), state == "visited", state == "dropped"});
    }
    story.views.push_back({t_, std::move(list)});
  }

  double t_ = 0.0;
  std::set<int> known_;
  std::set<std::string> found_;
};

}  // namespace

Story read_story(const std::vector<std::string>& lines) {
  Teller teller;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    try {
      teller.tell(Json::parse(lines[i]));
    } catch (const Json::exception&) {
      throw InputError(fmt::format("timeline.jsonl:{}: an event of a run with all its fields is allowed", i + 1));
    } catch (const InputError& e) {
      throw InputError(fmt::format("timeline.jsonl:{}: {}", i + 1, e.what()));
    }
  }
  if (teller.story.poses.empty()) throw InputError("timeline.jsonl: the robot did nothing in this run");
  return std::move(teller.story);
}

std::vector<mapping::Voxel> voxels_at(const Story& story, double t_s) {
  std::set<mapping::Voxel> occupied;
  for (const auto& [t, change] : story.voxels) {
    if (t > t_s) break;
    occupied.insert(change.on.begin(), change.on.end());
    for (const mapping::Voxel& v : change.off) occupied.erase(v);
  }
  return {occupied.begin(), occupied.end()};
}

std::vector<StoryRobot::Shape> shapes_at(const StoryRobot& robot, const robot::HeadState& head) {
  const auto turn = [](const StoryRobot::Axis& axis, double angle_rad) -> Eigen::Isometry3d {
    return Eigen::Translation3d(axis.point) * Eigen::AngleAxisd(angle_rad, axis.direction) *
           Eigen::Translation3d(-axis.point);
  };
  const Eigen::Isometry3d pan = turn(robot.pan, head.pan_rad), tilt = pan * turn(robot.tilt, head.tilt_rad);
  std::vector<StoryRobot::Shape> shapes = robot.shapes;
  for (StoryRobot::Shape& shape : shapes) {
    if (shape.part == StoryRobot::Part::kPan) shape.T_base_shape = pan * shape.T_base_shape;
    if (shape.part == StoryRobot::Part::kTilt) shape.T_base_shape = tilt * shape.T_base_shape;
  }
  return shapes;
}

StoryPose pose_at(const Story& story, double t_s) {
  const auto& list = story.poses;
  const auto after = std::upper_bound(list.begin(), list.end(), t_s, [](double t, const auto& e) { return t < e.t_s; });
  if (after == list.begin()) return list.front().value;
  if (after == list.end()) return list.back().value;
  const auto& [t0, a] = *std::prev(after);
  const auto& [t1, b] = *after;
  const double part = (t_s - t0) / (t1 - t0);
  const auto between = [part](const Pose2<Map, Base>& p, const Pose2<Map, Base>& q) {
    return Pose2<Map, Base>{std::lerp(p.x_m, q.x_m, part), std::lerp(p.y_m, q.y_m, part),
                            wrap_angle(p.yaw_rad + part * wrap_angle(q.yaw_rad - p.yaw_rad))};
  };
  return {between(a.believed, b.believed),
          between(a.truth, b.truth),
          {std::lerp(a.head.pan_rad, b.head.pan_rad, part), std::lerp(a.head.tilt_rad, b.head.tilt_rad, part)}};
}

}  // namespace amiss::page
