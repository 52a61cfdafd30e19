#include "page/events.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/base64.hpp"
#include "page/internal/robot_json.hpp"

namespace amiss::page {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::round(value * 1e3) / 1e3; }
/// Angles turn long levers.
double rounded_angle(double value) { return std::round(value * 1e4) / 1e4; }

Json vector(const Eigen::Vector3d& v) { return {rounded(v.x()), rounded(v.y()), rounded(v.z())}; }
Json vector(const Eigen::Vector2d& v) { return {rounded(v.x()), rounded(v.y())}; }
Json pose(const Pose2<Map, Base>& p) { return {rounded(p.x_m), rounded(p.y_m), rounded_angle(p.yaw_rad)}; }

/// x y z and the quaternion x y z w.
Json pose(const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond q(T.linear());
  Json json = vector(Eigen::Vector3d(T.translation()));
  for (const double value : {q.x(), q.y(), q.z(), q.w()}) json.push_back(rounded_angle(value));
  return json;
}

Json event(std::string_view name, Stamp stamp) { return {{"e", name}, {"t", rounded(seconds(stamp))}}; }
Json at(const std::optional<Stamp>& stamp) { return stamp ? Json(rounded(seconds(*stamp))) : Json(nullptr); }

/// Text of others (names in worlds) may be anything: what is no UTF-8 is replaced.
std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// An event that tells one thing.
std::string line_of(std::string_view name, Stamp stamp, const char* key, Json value) {
  Json json = event(name, stamp);
  json[key] = std::move(value);
  return line(json);
}

/// Four cells in a byte, the first in the lowest bits.
std::string packed(const FloorGrid& grid) {
  std::string bytes((grid.cells().size() + 3) / 4, '\0');
  for (std::size_t i = 0; i < grid.cells().size(); ++i) {
    const unsigned value = static_cast<unsigned>(grid.cells()[i]) << (2 * (i % 4));
    bytes[i / 4] = static_cast<char>(static_cast<unsigned char>(bytes[i / 4]) | value);
  }
  return bytes;
}

Json floor_json(const FloorGrid& floor) {
  return {{"resolution", floor.resolution_m()},
          {"origin", vector(floor.origin_m())},
          {"width", floor.width()},
          {"height", floor.height()},
          {"cells", base64(packed(floor))}};
}

std::string_view state_of(const knowledge::Region& region) {
  if (region.withdrawn) return "withdrawn";
  return region.examined ? "examined" : "open";
}

std::string_view state_of(const knowledge::View& view) {
  if (view.visited_at) return "visited";
  return view.dropped ? "dropped" : "open";
}

std::string_view name_of(mission::PlannedStep::Action action) {
  switch (action) {
    case mission::PlannedStep::Action::kGoto:
      return "goto";
    case mission::PlannedStep::Action::kExplore:
      return "explore";
    case mission::PlannedStep::Action::kExamine:
      return "examine";
  }
  return "";
}

/// What hangs over the floor or stands on it; the floor itself would hide all.
std::vector<mapping::Voxel> above_floor(const mapping::VoxelMap& map) {
  std::vector<mapping::Voxel> voxels = map.voxels(Occupancy::kOccupied);
  std::erase_if(voxels, [](const mapping::Voxel& v) { return v.z < 0; });
  return voxels;
}

}  // namespace

bool PlacedObject::operator==(const PlacedObject& other) const {
  return name == other.name && kind == other.kind && place.p == other.place.p && found == other.found &&
         covered == other.covered && found_at_s == other.found_at_s && error_m == other.error_m &&
         cover == other.cover && purity == other.purity;
}

std::string voxels_text(std::span<const mapping::Voxel> voxels) {
  std::string bytes;
  bytes.reserve(voxels.size() * 6);
  for (const mapping::Voxel& v : voxels)
    for (const int index : {v.x, v.y, v.z}) {
      const auto value = static_cast<unsigned>(index);
      bytes += static_cast<char>(value & 255U);
      bytes += static_cast<char>(value >> 8U & 255U);
    }
  return base64(bytes);
}

std::string start_line(const Beginning& b) {
  Json json = event("start", Stamp{});
  json["schema"] = kSchema;
  json["version"] = b.version;
  json["world"] = b.world;
  json["method"] = b.method;
  json["seed"] = b.seed;
  json["place"] = {{"world", b.place.world}, {"robot", b.place.robot}, {"T_world_map", pose(b.place.T_world_map.T)}};
  json["floor"] = floor_json(*b.floor);
  json["resolution"] = b.reference->resolution_m();
  json["reference"] = voxels_text(above_floor(*b.reference));
  json["robot"] = robot_json(*b.model);
  json["referee"] = {{"max_error_m", b.max_error_m}, {"min_cover", b.min_cover}, {"min_purity", b.min_purity}};
  return line(json);
}

std::string pose_line(const mission::StepEvent& step, const Pose2<Map, Base>& truth) {
  Json json = event("pose", step.pose.stamp);
  json["p"] = pose(step.pose.T_map_base);
  json["true"] = pose(truth);
  json["head"] = {rounded_angle(step.head.pan_rad), rounded_angle(step.head.tilt_rad)};
  return line(json);
}

std::string progress_line(const mission::ProgressEvent& e, int found) {
  Json json = event("progress", e.stamp);
  json["seen_m2"] = rounded(e.seen_m2);
  json["regions"] = e.regions;
  json["examined"] = e.examined;
  json["found"] = found;
  return line(json);
}

std::string voxels_line(Stamp stamp, std::span<const mapping::Voxel> occupied,
                        std::span<const mapping::Voxel> cleared) {
  Json json = event("voxels", stamp);
  json["on"] = voxels_text(occupied);
  json["off"] = voxels_text(cleared);
  return line(json);
}

std::string difference_line(Stamp stamp, const change::Difference& difference) {
  Json json = event("difference", stamp);
  json["appeared"] = voxels_text(difference.appeared);
  json["vanished"] = voxels_text(difference.vanished);
  json["unseen"] = difference.unseen;
  return line(json);
}

std::string regions_line(Stamp stamp, const std::vector<knowledge::Region>& regions) {
  Json list = Json::array();
  for (const knowledge::Region& r : regions) {
    list.push_back({{"id", r.id},
                    {"p", vector(r.cylinder.centre_map)},
                    {"radius", rounded(r.cylinder.radius_m)},
                    {"z", {rounded(r.cylinder.z_low_m), rounded(r.cylinder.z_high_m)}},
                    {"voxels", r.voxels},
                    {"state", state_of(r)},
                    {"first_seen", rounded(seconds(r.first_seen))},
                    {"examined_at", at(r.examined_at)}});
  }
  return line_of("regions", stamp, "list", std::move(list));
}

std::string views_line(Stamp stamp, const std::vector<knowledge::View>& views) {
  Json list = Json::array();
  for (const knowledge::View& v : views) {
    list.push_back({{"id", v.id},
                    {"p", pose(v.T_map_base)},
                    {"angle", rounded_angle(v.angle_rad)},
                    {"height", rounded(v.height_m)},
                    {"state", state_of(v)}});
  }
  return line_of("views", stamp, "list", std::move(list));
}

std::string plan_line(const mission::PlanEvent& e) {
  Json steps = Json::array();
  for (const mission::PlannedStep& s : *e.steps) {
    const bool view = s.visit.kind == mission::Visit::Kind::kExplore;
    steps.push_back({{"action", name_of(s.action)},
                     {"of", view ? "view" : "region"},
                     {"id", s.visit.id},
                     {"p", pose(s.visit.T_map_base)}});
  }
  Json json = event("plan", e.stamp);
  json["number"] = e.number;
  json["steps"] = std::move(steps);
  return line(json);
}

std::string step_line(const mission::ActionEvent& e) { return line_of("step", e.stamp, "step", e.step); }

std::string path_line(const mission::PathEvent& e) {
  Json points = Json::array();
  for (const Eigen::Vector2d& p : e.path->points_m) points.push_back(vector(p));
  return line_of("path", e.stamp, "points", std::move(points));
}

std::string frame_line(Stamp taken, Slice colour, Slice depth) {
  Json json = event("frame", taken);
  json["colour"] = {colour.begin, colour.bytes};
  json["depth"] = {depth.begin, depth.bytes};
  return line(json);
}

std::string examined_line(const mission::ExaminationEvent& e, Slice picture) {
  Json segments = Json::array();
  for (const segment::Segment& s : *e.segments) {
    segments.push_back({{"p", vector(s.centre_map)},
                        {"size", vector(s.size_m)},
                        {"yaw", rounded_angle(s.yaw_rad)},
                        {"points", s.points},
                        {"colour", {s.mean_colour.r, s.mean_colour.g, s.mean_colour.b}},
                        {"cut", s.cut}});
  }
  Json json = event("examined", e.stamp);
  json["region"] = e.region;
  json["picture"] = {picture.begin, picture.bytes};
  json["segments"] = std::move(segments);
  return line(json);
}

std::string objects_line(Stamp stamp, const std::vector<PlacedObject>& objects) {
  Json list = Json::array();
  for (const PlacedObject& o : objects) {
    list.push_back({{"name", o.name},
                    {"kind", o.kind},
                    {"p", vector(o.place.p)},
                    {"found", o.found},
                    {"found_at", o.found ? Json(rounded(o.found_at_s)) : Json(nullptr)},
                    {"covered", o.covered},
                    {"error", o.covered ? Json(rounded(o.error_m)) : Json(nullptr)},
                    {"cover", rounded(o.cover)},
                    {"purity", rounded(o.purity)}});
  }
  return line_of("objects", stamp, "list", std::move(list));
}

std::string bodies_line(Stamp stamp, const std::vector<MovableBody>& bodies, const std::vector<std::string>& gone) {
  Json list = Json::array();
  for (const MovableBody& b : bodies)
    list.push_back({{"name", b.name}, {"kind", b.kind}, {"pose", pose(b.T_map_body.T)}});
  Json json = event("bodies", stamp);
  json["list"] = std::move(list);
  json["gone"] = gone;
  return line(json);
}

std::string collision_line(const Touch& touch) {
  Json json = event("collision", touch.stamp);
  json["link"] = touch.link;
  json["body"] = touch.body;
  json["p"] = vector(touch.place.p);
  return line(json);
}

std::string script_line(const Occurrence& occurrence) {
  return line_of("script", occurrence.stamp, "text", occurrence.text);
}

std::string log_line(Stamp stamp, std::string_view text) { return line_of("log", stamp, "text", text); }

std::string end_line(Stamp stamp, std::string_view report_json) {
  return line_of("end", stamp, "report", Json::parse(report_json));
}

}  // namespace amiss::page
