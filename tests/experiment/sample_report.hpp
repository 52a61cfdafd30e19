// report.json of a run as `amiss tidy` writes it.
#pragma once

#include "report/tidy_report.hpp"

namespace amiss::experiment {

inline report::TidyReport sample_report() {
  report::TidyReport report;
  report.version = "0.1.0";
  report.world = "lab_30";
  report.seed = 7;
  report.method = "static";
  report.outcome = "found";
  report.objects = {{"mug_1", "mug", {1.0, 2.0, 0.04}, true, 61.5, 0.0123, true, 5, 30.0},
                    {"ball_1", "ball", {3, 4, 0.1}, true, 81.5, 0.02, true, 8, 48.0}};
  report.segmentation_actions = 8;
  report.segmentation_cost_s = 48.0;
  report.segments = 20;
  report.segments_false = 15;
  report.simulated_s = 81.52;
  report.distance_m = 17.0;
  report.wall_s = 4.0;
  report.segmentation_mean_ms = 14.0;
  report.differencing_mean_ms = 0.3;
  return report;
}

}  // namespace amiss::experiment
