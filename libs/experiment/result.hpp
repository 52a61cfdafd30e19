// What a trial gave: report.json of its run -> Result, and the two files that are kept of it.
// The result file holds nothing that differs between two runs of the same trial; times on the clock have a file of
// their own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiment/trial.hpp"

namespace amiss::experiment {

struct FoundObject {
  std::string name;
  bool found = false;
  double at_s = 0.0;                 // simulated
  int segmentations = 0;             // until then
  double segmentation_cost_s = 0.0;  // simulated time of those
};

struct TrialResult {
  Trial trial;
  bool failed = false;  // the program ended without a report
  std::string why;      // of a failure
  std::string outcome;  // found, time_limit, ...
  int placed = 0, found = 0, segmentations = 0, segments = 0, segments_false = 0;
  int regions = 0, regions_false = 0, collisions = 0, failed_actions = 0, view_triangles = 0;
  double simulated_s = 0.0, segmentation_cost_s = 0.0, driving_s = 0.0, distance_m = 0.0;
  std::string digest;
  std::vector<FoundObject> objects;

  [[nodiscard]] bool complete() const { return !failed && found == placed; }
};

/// On the clock.
struct TrialTimes {
  double wall_s = 0.0, segmentation_mean_ms = 0.0, differencing_mean_ms = 0.0;
};

/// The text of the result file, from report.json or, for a failure, from why there is none.
[[nodiscard]] std::string result_text(const Trial& trial, std::string_view report_json);
[[nodiscard]] std::string failure_text(const Trial& trial, std::string_view why);
[[nodiscard]] std::string times_text(std::string_view report_json);

/// InputError naming `file` when it is no result, was changed since it was written, or is one of another trial or of
/// another program.
[[nodiscard]] TrialResult parse_result(const Trial& trial, std::string_view text, const std::string& file);
[[nodiscard]] TrialTimes parse_times(std::string_view text, const std::string& file);

}  // namespace amiss::experiment
