#include "detect_output.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/top_view.hpp"

namespace amiss::app {

namespace {

using nlohmann::ordered_json;

constexpr Rgb kPink{255, 20, 160};
constexpr Rgb kPlain{160, 160, 160};  // of clouds without colours

/// Whole tenths of a millimetre or thousandths: a number of a report, not of a calculation.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

ordered_json json_of(const Eigen::Vector3d& p) { return {rounded(p.x()), rounded(p.y()), rounded(p.z())}; }

/// The number that a verdict rests on, and the parameter it was held against.
ordered_json reason_of(const change::Decision& d, const change::NovelParams& p) {
  using change::Verdict;
  const auto because = [](const char* number, double value, const char* parameter, double limit) {
    return ordered_json{{"number", number}, {"value", rounded(value)}, {"parameter", parameter}, {"limit", limit}};
  };
  switch (d.verdict) {
    case Verdict::kNovel:
      if (d.overlap_moved < p.max_overlap) {
        return because("overlap_moved", d.overlap_moved, "detect.max_overlap", p.max_overlap);
      }
      if (d.taken > p.max_taken) return because("taken", d.taken, "detect.max_taken", p.max_taken);
      if (d.left_over > p.max_left_over)
        return because("left_over", d.left_over, "detect.max_left_over", p.max_left_over);
      return because("colour_distance", d.colour_distance, "detect.max_colour_distance", p.max_colour_distance);
    case Verdict::kAtRest:
      return because("overlap_at_rest", d.overlap_at_rest, "detect.max_overlap", p.max_overlap);
    case Verdict::kMovedALittle:
      return because("overlap_moved", d.overlap_moved, "detect.max_overlap", p.max_overlap);
    case Verdict::kUnseen:
      return because("unseen", d.unseen, "detect.max_unseen", p.max_unseen);
    case Verdict::kShallow:
      return because("depth_m", d.depth_m, "detect.min_depth", p.min_depth_m);
    case Verdict::kContinued:
      return because("continued", d.continued, "detect.max_continued", p.max_continued);
    case Verdict::kNudged:
      return because("nudged", d.nudged, "detect.max_nudged", p.max_nudged);
    case Verdict::kTooSmall:
      return because("points", d.points, "detect.min_points", p.min_points);
    case Verdict::kTooLarge:
      return because("size_m", (d.high_m - d.low_m).maxCoeff(), "detect.max_size", p.max_size_m);
    case Verdict::kNotVerified:
      break;
  }
  return nullptr;
}

ordered_json json_of(const change::Decision& d, const change::NovelParams& params) {
  return {{"verdict", change::name_of(d.verdict)},
          {"because", reason_of(d, params)},
          {"object", d.object ? ordered_json(*d.object + 1) : ordered_json(nullptr)},
          {"source", d.source},
          {"points", d.points},
          {"label", to_string(d.label)},
          {"low_m", json_of(d.low_m)},
          {"high_m", json_of(d.high_m)},
          {"support_height_m", rounded(d.support_height_m)},
          {"overlap_at_rest", rounded(d.overlap_at_rest)},
          {"overlap_moved", rounded(d.overlap_moved)},
          {"moved_m", rounded(d.moved_m)},
          {"turned_deg", rounded(degrees(d.turned_rad))},
          {"taken", rounded(d.taken)},
          {"left_over", rounded(d.left_over)},
          {"colour_distance", rounded(d.colour_distance)},
          {"unseen", rounded(d.unseen)},
          {"depth_m", rounded(d.depth_m)},
          {"continued", rounded(d.continued)},
          {"nudged", rounded(d.nudged)}};
}

}  // namespace

std::vector<std::vector<std::uint32_t>> points_in_file(const change::Detection& detection, const LoadedScene& current) {
  std::vector<std::vector<std::uint32_t>> objects;
  for (const change::NovelObject& object : detection.objects) {
    auto& points = objects.emplace_back();
    for (const std::uint32_t i : object.points) points.push_back(current.in_file[i]);
  }
  return objects;
}

dataset::CloudFile painted(const LoadedScene& current, const std::vector<std::vector<std::uint32_t>>& objects) {
  dataset::CloudFile out = current.file;
  Cloud<Map>& cloud = out.mesh.vertices;
  if (cloud.colours.empty()) cloud.colours.assign(cloud.points.size(), kPlain);
  std::erase_if(out.fields, [](const dataset::ScalarField& field) { return field.name == "object"; });
  dataset::ScalarField& number = out.fields.emplace_back();
  number.name = "object";
  number.values.assign(cloud.points.size(), 0.0);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    for (const std::uint32_t i : objects[k]) {
      cloud.colours[i] = kPink;
      number.values[i] = static_cast<double>(k + 1);
    }
  }
  return out;
}

ordered_json objects_json(const change::Detection& detection, const change::NovelParams& params) {
  ordered_json objects = ordered_json::array(), decisions = ordered_json::array(), limits = ordered_json::object();
  for (const change::NovelObject& object : detection.objects) {
    objects.push_back({{"object", objects.size() + 1},
                       {"points", object.points.size()},
                       {"centre_m", json_of(0.5 * (object.low_m + object.high_m))},
                       {"low_m", json_of(object.low_m)},
                       {"high_m", json_of(object.high_m)}});
  }
  for (const change::Decision& decision : detection.decisions) decisions.push_back(json_of(decision, params));
  change::NovelParams used = params;
  ParamTable table;
  change::describe(table, used);
  for (const ParamTable::Row& row : table.rows()) limits[row.key] = row.print();
  return {{"schema", "amiss.objects.1"}, {"objects", objects}, {"decisions", decisions}, {"parameters", limits}};
}

std::string picture_of(const LoadedScene& current, const std::vector<std::vector<std::uint32_t>>& objects) {
  std::vector<report::MarkedPoints> marks;
  for (const auto& points : objects) marks.push_back({points, kPink, std::to_string(marks.size() + 1)});
  return report::top_view_png(current.file.cloud(), marks);
}

}  // namespace amiss::app
