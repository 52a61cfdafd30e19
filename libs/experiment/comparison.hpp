// What the trials of a batch (a world and a number of objects) say of the methods: results -> samples, their quartiles
// and intervals, and the paired comparison of the two. A trial that did not find all, or failed, counts as infinite:
// more than any other, so that it moves medians and ranks and is never dropped. Thesis, Section 4.3.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiment/result.hpp"
#include "experiment/statistics.hpp"
#include "report/search_times.hpp"

namespace amiss::experiment {

/// What is measured of a trial: "segmentations" (actions until all objects were found), and "time_NAME_s" (seconds
/// until then) for each of report::kSegmentationTimes.
[[nodiscard]] std::vector<std::string> measures();
[[nodiscard]] std::string time_measure(std::string_view segmentation_times);
/// Infinite when not all were found. ArgumentError for a measure that is none.
[[nodiscard]] double measured(const TrialResult& result, const std::string& measure);
/// When each object was found with other segmentation times, sorted; those that were not are left out.
[[nodiscard]] std::vector<double> found_at_s(const TrialResult& result, const report::SegmentationTimes& times);

struct Sample {
  std::string method;
  std::vector<std::uint64_t> seeds;
  std::vector<double> values;  // one for each seed
};

/// The samples of the methods, in the order of the spec; a trial without result is in none.
struct Cell {
  std::string world, measure;
  int objects = 0;
  std::vector<Sample> samples;

  [[nodiscard]] const Sample* sample(std::string_view method) const;  // null when there is none or it is empty
};
[[nodiscard]] Cell cell_of(const std::vector<TrialResult>& results, const std::string& world, int objects,
                           const std::string& measure);
/// Worlds, then objects, then measures.
[[nodiscard]] std::vector<Cell> cells_of(const Spec& spec, const std::vector<TrialResult>& results);

struct Described {
  int n = 0;
  double mean = 0.0;
  Quartiles quartiles;
  Interval median_95;  // bootstrap
};
/// The resamples are drawn from the stream of this name. `values` not empty.
[[nodiscard]] Described described(const std::vector<double>& values, const std::string& stream);
[[nodiscard]] Described described(const Cell& cell, const Sample& sample);

/// Static minus dynamic, paired by the seed: above 0 the dynamic method needs less. When neither found all: 0.
struct Comparison {
  Described difference;
  SignedRank test;
  double ratio_of_medians = 0.0, ratio_of_means = 0.0;  // static / dynamic, over the pairs; NaN when both are infinite
};
/// Nothing when a method is missing or no seed has both.
[[nodiscard]] std::optional<Comparison> compared(const Cell& cell);

}  // namespace amiss::experiment
