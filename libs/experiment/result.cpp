#include "experiment/result.hpp"

#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::experiment {

namespace {

using Json = nlohmann::ordered_json;

Json head_of(const Trial& trial) {
  return {{"schema", 1},
          {"id", trial.id},
          {"world", trial.world},
          {"method", trial.method},
          {"objects", trial.objects},
          {"seed", trial.seed},
          {"scatter_seed", trial.scatter_seed},
          {"program", trial.program}};
}

std::string dumped(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace); }

/// With a hash of all that stands before it, so that a change is seen.
std::string sealed(Json json) {
  json["sha256"] = sha256(dumped(json));
  return dumped(json) + "\n";
}

bool is_unbroken(Json json) {
  const std::string hash = json.at("sha256");
  json.erase("sha256");
  return sha256(dumped(json)) == hash;
}

FoundObject object_of(const Json& o) {
  FoundObject object{o.at("name"), o.at("found"), 0.0, 0, 0.0};
  if (!object.found) return object;
  object.at_s = o.at("found_at_s");
  object.segmentations = o.at("segmentations");
  object.segmentation_cost_s = o.at("segmentation_cost_s");
  return object;
}

void fill(TrialResult& result, const Json& report) {
  result.outcome = report.at("outcome");
  result.placed = report.at("objects_placed");
  result.found = report.at("objects_found");
  result.segmentations = report.at("segmentation_actions");
  result.segments = report.at("segmentation").at("segments");
  result.segments_false = report.at("segmentation").at("false");
  result.segmentation_cost_s = report.at("segmentation").at("cost_s");
  result.regions = report.at("regions").at("detected");
  result.regions_false = report.at("regions").at("false");
  result.collisions = report.at("collisions");
  result.failed_actions = report.at("failed_actions");
  result.view_triangles = report.at("view_triangles");
  result.simulated_s = report.at("time").at("simulated_s");
  result.driving_s = report.at("time").at("driving_s");
  result.distance_m = report.at("distance_m");
  result.digest = report.at("digest");
  for (const Json& o : report.at("objects")) result.objects.push_back(object_of(o));
}

}  // namespace

std::string result_text(const Trial& trial, std::string_view report_json) {
  Json report = Json::parse(report_json);
  for (const char* key : {"wall_s", "real_time_factor"}) report.at("time").erase(key);
  for (const char* group : {"segmentation", "differencing"}) {
    for (const char* key : {"mean_ms", "max_ms"}) report.at(group).erase(key);
  }
  Json json = head_of(trial);
  json["status"] = "done";
  json["report"] = std::move(report);
  return sealed(std::move(json));
}

std::string failure_text(const Trial& trial, std::string_view why) {
  Json json = head_of(trial);
  json["status"] = "failed";
  json["why"] = why;
  return sealed(std::move(json));
}

std::string times_text(std::string_view report_json) {
  const Json report = Json::parse(report_json);
  const Json json{{"wall_s", report.at("time").at("wall_s")},
                  {"segmentation_mean_ms", report.at("segmentation").at("mean_ms")},
                  {"differencing_mean_ms", report.at("differencing").at("mean_ms")}};
  return json.dump() + "\n";
}

TrialResult parse_result(const Trial& trial, std::string_view text, const std::string& file) {
  try {
    const Json json = Json::parse(text);
    TrialResult result;
    result.trial = trial;
    Trial named{json.at("id"),   json.at("world"),        json.at("method"), json.at("objects"),
                json.at("seed"), json.at("scatter_seed"), trial.program};
    if (!is_unbroken(json)) throw InputError(file + ": was changed since it was written (its sha256 disagrees)");
    if (named != trial) throw InputError(file + ": is the result of another trial");
    const std::string program = json.at("program");
    if (program != trial.program) {
      throw InputError(file + ": comes from another program (" + program + ") than the plan's (" + trial.program +
                       "); results of two programs are not mixed");
    }
    result.failed = json.at("status") != "done";
    if (result.failed) {
      result.why = json.at("why");
    } else {
      fill(result, json.at("report"));
    }
    return result;
  } catch (const nlohmann::json::exception& e) {
    throw InputError(file + ": is no result of a trial (" + e.what() + ")");
  }
}

TrialTimes parse_times(std::string_view text, const std::string& file) {
  try {
    const Json json = Json::parse(text);
    return {json.at("wall_s"), json.at("segmentation_mean_ms"), json.at("differencing_mean_ms")};
  } catch (const nlohmann::json::exception& e) {
    throw InputError(file + ": tells no times of a trial (" + e.what() + ")");
  }
}

}  // namespace amiss::experiment
