// The batches of an experiment (a world, a number of objects and a method) and the paired comparisons of the methods as
// tables, for programs and, with fewer columns and rounded, for people.
#pragma once

#include "experiment/comparison.hpp"
#include "experiment/table.hpp"

namespace amiss::experiment {

/// World, objects, method: how many found all, median and quartiles of all measures (comparison.hpp).
[[nodiscard]] Table summary_table(const std::vector<Trial>& trials, const std::vector<TrialResult>& results);
[[nodiscard]] Table short_summary(const std::vector<Trial>& trials, const std::vector<TrialResult>& results);

/// World, objects, measure: both samples, their differences and the test.
[[nodiscard]] Table statistics_table(const Spec& spec, const std::vector<TrialResult>& results);
[[nodiscard]] Table short_statistics(const Spec& spec, const std::vector<TrialResult>& results);

}  // namespace amiss::experiment
