// report.json of a tidy-up run: TidyReport -> JSON text, its digest, and the table for people.
// The digest is a SHA-256 over everything that is not wall time, and over the artefacts that are given to it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/frames.hpp"

namespace amiss::report {

struct ReportedObject {
  std::string name, kind;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // true, world frame
  bool found = false;
  double found_at_s = 0.0;
  double error_m = 0.0;
  bool covered = false;              // by a segment: error_m means something
  int segmentations = 0;             // until it was found
  double segmentation_cost_s = 0.0;  // simulated time of those
};

struct ReportedCollision {
  double at_s = 0.0;
  std::string link, body;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // world frame
};

struct TidyReport {
  std::string version, world, method, outcome;
  std::string why;                               // of an outcome that a trouble brought about
  std::map<std::string, int> navigation_errors;  // how often which, by word
  std::uint64_t seed = 0;
  std::vector<ReportedObject> objects;
  std::vector<ReportedCollision> collisions;
  int segments = 0, segments_false = 0;
  double segmentation_cost_s = 0.0;                              // simulated, of all actions
  double segmentation_mean_ms = 0.0, segmentation_max_ms = 0.0;  // on the clock
  int segmentation_actions = 0, view_triangles = 0, plans = 0, failed_actions = 0;
  int regions_detected = 0, regions_false = 0, regions_withdrawn = 0;
  double coverage = 0.0, distance_m = 0.0;
  double simulated_s = 0.0, driving_s = 0.0, segmenting_s = 0.0, wall_s = 0.0;
  double rmse_m = 0.0, rmse_rad = 0.0, max_m = 0.0;
  int differencing_calls = 0;
  double differencing_mean_ms = 0.0, differencing_max_ms = 0.0;

  [[nodiscard]] int found() const;
};

/// `artefacts`: bytes that the digest covers too (trajectories, the final map, ...).
[[nodiscard]] std::string to_json(const TidyReport& report, std::string_view artefacts);
[[nodiscard]] std::string to_table(const TidyReport& report);

}  // namespace amiss::report
