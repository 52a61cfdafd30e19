// Results of trials that were never run.
#pragma once

#include "experiment/result.hpp"

namespace amiss::experiment {

/// Objects found one after the other, each at the next of `at_s`, with one segmentation action of `action_s` each.
inline TrialResult sample_result(const std::string& method, std::uint64_t seed, const std::vector<double>& at_s,
                                 int placed, double action_s) {
  TrialResult r;
  r.trial = {"id_" + method + std::to_string(seed), "lab_30", method, placed, seed, 100, "program"};
  r.outcome = "found";
  r.placed = placed;
  r.found = r.segmentations = static_cast<int>(at_s.size());
  r.digest = "digest";
  for (std::size_t i = 0; i < static_cast<std::size_t>(placed); ++i) {
    FoundObject o{"object_" + std::to_string(i), i < at_s.size()};
    if (o.found) {
      o.at_s = at_s[i];
      o.segmentations = static_cast<int>(i) + 1;
      o.segmentation_cost_s = action_s * o.segmentations;
    }
    r.objects.push_back(o);
  }
  return r;
}

inline TrialResult sample_failure(const std::string& method, std::uint64_t seed, int placed) {
  TrialResult r = sample_result(method, seed, {}, placed, 1.0);
  r.failed = true;
  r.why = "ended by signal 11";
  return r;
}

}  // namespace amiss::experiment
