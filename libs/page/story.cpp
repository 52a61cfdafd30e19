#include "page/story.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/result.hpp"

namespace amiss::page {

namespace {

using Json = nlohmann::json;

std::string from_base64(const std::string& text) {
  std::string bytes;
  unsigned group = 0, bits = 0;
  for (const char c : text) {
    unsigned digit = 0;
    if (c >= 'A' && c <= 'Z') {
      digit = static_cast<unsigned>(c - 'A');
    } else if (c >= 'a' && c <= 'z') {
      digit = static_cast<unsigned>(c - 'a') + 26U;
    } else if (c >= '0' && c <= '9') {
      digit = static_cast<unsigned>(c - '0') + 52U;
    } else if (c == '+' || c == '/') {
      digit = c == '+' ? 62U : 63U;
    } else {
      break;  // the filling at the end
    }
    group = (group << 6U | digit) & 0xffffU;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 255U);
  }
  return bytes;
}

double number(const Json& list, std::size_t i) { return list.at(i).get<double>(); }

FloorGrid floor_of(const Json& json) {
  constexpr int kMostCells = 20000;
  const int width = json.at("width"), height = json.at("height");
  const double resolution_m = json.at("resolution");
  const std::string bytes = from_base64(json.at("cells"));
  const bool good = width >= 0 && height >= 0 && width < kMostCells && height < kMostCells && resolution_m > 0.0;
  const std::size_t cells = good ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0;
  if (!good || bytes.size() != (cells + 3) / 4) throw InputError("the floor has another size than it says");
  FloorGrid floor(resolution_m, Eigen::Vector2d(number(json.at("origin"), 0), number(json.at("origin"), 1)), width,
                  height);
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
    if (kind == "plan") {
      const int number = e.at("number");
      note(Note::Kind::kPlan, fmt::format("plan {} of {} steps", number, e.at("steps").size()));
    }
    if (kind == "examined") examined(e);
    if (kind == "collision") note(Note::Kind::kCollision, "touched " + e.at("body").get<std::string>());
    if (kind == "log") note(Note::Kind::kLog, e.at("text"));
    if (kind == "end") story.outcome = e.at("report").value("outcome", "");
  }
  Story story;

 private:
  void note(Note::Kind kind, std::string text) { story.notes.push_back({t_, {kind, std::move(text)}}); }
  void start(const Json& e) {
    if (!e.contains("place")) throw InputError("the run does not say where it took place: an earlier amiss made it");
    story.world = e.at("world");
    story.method = e.at("method");
    story.seed = e.at("seed");
    const Json& place = e["place"];
    story.place = {place.at("world"), place.at("robot"), {pose_of(place.at("T_world_map"))}};
    story.floor = floor_of(e.at("floor"));
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
      list.push_back({r.at("id"), point_of(r.at("p")), r.at("radius"), state == "examined", state == "withdrawn"});
      if (known_.insert(list.back().id).second)
        note(Note::Kind::kDetected, fmt::format("region {} detected", list.back().id));
    }
    story.regions.push_back({t_, std::move(list)});
  }
  void objects(const Json& e) {
    std::vector<StoryObject> list;
    for (const Json& o : e.at("list")) {
      const Json& p = o.at("p");
      list.push_back({o.at("name"), {Eigen::Vector3d(number(p, 0), number(p, 1), number(p, 2))}, o.at("found")});
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
