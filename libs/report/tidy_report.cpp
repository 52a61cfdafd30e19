#include "report/tidy_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "report/search_times.hpp"

namespace amiss::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

/// Six decimals are more than any figure here means, and keep the text short.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json position(const Eigen::Vector3d& p) { return {rounded(p.x()), rounded(p.y()), rounded(p.z())}; }

Json objects_json(const TidyReport& report) {
  Json objects = Json::array();
  for (const ReportedObject& o : report.objects) {
    objects.push_back({{"name", o.name},
                       {"kind", o.kind},
                       {"position", position(o.position_m)},
                       {"found", o.found},
                       {"found_at_s", o.found ? Json(rounded(o.found_at_s)) : Json(nullptr)},
                       {"error_m", o.covered ? Json(rounded(o.error_m)) : Json(nullptr)},
                       {"segmentations", o.found ? Json(o.segmentations) : Json(nullptr)},
                       {"segmentation_cost_s", o.found ? Json(rounded(o.segmentation_cost_s)) : Json(nullptr)}});
  }
  return objects;
}

Json collisions_json(const TidyReport& report) {
  Json collisions = Json::array();
  for (const ReportedCollision& c : report.collisions) {
    collisions.push_back(
        {{"at_s", rounded(c.at_s)}, {"link", c.link}, {"body", c.body}, {"position", position(c.position_m)}});
  }
  return collisions;
}

/// The total search time with each of the segmentation times of the thesis.
Json search_times_json(const TidyReport& r) {
  Json times;
  for (const SegmentationTimes& t : kSegmentationTimes) {
    const SearchMoment end{r.simulated_s, r.segmentation_actions, r.segmentation_cost_s};
    times[std::string(t.name)] = rounded(recomputed_s(end, t, r.method));
  }
  return times;
}

Json without_wall_time(const TidyReport& r) {
  Json json;
  json["schema"] = kSchema;
  json["version"] = r.version;
  json["world"] = r.world;
  json["seed"] = r.seed;
  json["method"] = r.method;
  json["outcome"] = r.outcome;
  if (!r.why.empty()) json["why"] = r.why;
  if (!r.navigation_errors.empty()) json["navigation_errors"] = r.navigation_errors;
  json["objects_placed"] = r.objects.size();
  json["objects_found"] = r.found();
  json["segmentation_actions"] = r.segmentation_actions;
  json["segmentation"] = {
      {"segments", r.segments}, {"false", r.segments_false}, {"cost_s", rounded(r.segmentation_cost_s)}};
  json["regions"] = {{"detected", r.regions_detected}, {"false", r.regions_false}, {"withdrawn", r.regions_withdrawn}};
  json["view_triangles"] = r.view_triangles;
  json["plans"] = r.plans;
  json["failed_actions"] = r.failed_actions;
  json["coverage"] = rounded(r.coverage);
  json["collisions"] = r.collisions.size();
  json["distance_m"] = rounded(r.distance_m);
  json["time"] = {{"simulated_s", rounded(r.simulated_s)},
                  {"driving_s", rounded(r.driving_s)},
                  {"segmenting_s", rounded(r.segmenting_s)},
                  {"search_s", search_times_json(r)}};
  json["localization"] = {
      {"rmse_m", rounded(r.rmse_m)}, {"rmse_rad", rounded(r.rmse_rad)}, {"max_m", rounded(r.max_m)}};
  json["differencing"] = {{"calls", r.differencing_calls}};
  json["objects"] = objects_json(r);
  json["collision_list"] = collisions_json(r);
  return json;
}

}  // namespace

int TidyReport::found() const {
  return static_cast<int>(std::count_if(objects.begin(), objects.end(), [](const auto& o) { return o.found; }));
}

std::string to_json(const TidyReport& report, std::string_view artefacts) {
  Json json = without_wall_time(report);
  const std::string digest = sha256(json.dump() + std::string(artefacts));
  json["time"]["wall_s"] = rounded(report.wall_s);
  json["time"]["real_time_factor"] = report.wall_s > 0.0 ? rounded(report.simulated_s / report.wall_s) : 0.0;
  json["segmentation"]["mean_ms"] = rounded(report.segmentation_mean_ms);
  json["segmentation"]["max_ms"] = rounded(report.segmentation_max_ms);
  json["differencing"]["mean_ms"] = rounded(report.differencing_mean_ms);
  json["differencing"]["max_ms"] = rounded(report.differencing_max_ms);
  json["digest"] = digest;
  return json.dump(2) + "\n";
}

std::string to_table(const TidyReport& report) {
  std::string table =
      fmt::format("{:<24}{:<7}{:>10}{:>11}   {}\n", "object", "found", "after", "error", "where (world)");
  for (const ReportedObject& o : report.objects) {
    const std::string after = o.found ? fmt::format("{:.0f} s", o.found_at_s) : "-";
    const std::string error = o.covered ? fmt::format("{:.3f} m", o.error_m) : "-";
    table += fmt::format("{:<24}{:<7}{:>10}{:>11}   ({:.2f}, {:.2f})\n", o.name, o.found ? "yes" : "no", after, error,
                         o.position_m.x(), o.position_m.y());
  }
  table +=
      fmt::format("{} of {} found ({}), {} segmentations, {} regions ({} false), {} collisions\n", report.found(),
                  report.objects.size(), report.outcome + (report.why.empty() ? "" : ": " + report.why),
                  report.segmentation_actions, report.regions_detected, report.regions_false, report.collisions.size());
  table += fmt::format("{:.0f} m driven in {:.0f} s (simulated), {:.1f} s on the clock: {:.0f} times real time\n",
                       report.distance_m, report.simulated_s, report.wall_s,
                       report.wall_s > 0.0 ? report.simulated_s / report.wall_s : 0.0);
  return table;
}

}  // namespace amiss::report
