#include "experiment/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/result.hpp"

namespace amiss::experiment {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::string_view kSegmentations = "segmentations";

/// As in report.json, so that what was equal before a sum stays equal after it.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

double recomputed(const FoundObject& o, const report::SegmentationTimes& times, const std::string& method) {
  return rounded(report::recomputed_s({o.at_s, o.segmentations, o.segmentation_cost_s}, times, method));
}

}  // namespace

std::string time_measure(std::string_view segmentation_times) { return fmt::format("time_{}_s", segmentation_times); }

std::vector<std::string> measures() {
  std::vector<std::string> names{std::string(kSegmentations)};
  for (const report::SegmentationTimes& times : report::kSegmentationTimes) names.push_back(time_measure(times.name));
  return names;
}

double measured(const TrialResult& result, const std::string& measure) {
  if (measure == kSegmentations) return result.complete() ? result.segmentations : kInfinite;
  for (const report::SegmentationTimes& times : report::kSegmentationTimes) {
    if (measure != time_measure(times.name)) continue;
    if (!result.complete()) return kInfinite;
    const auto found = found_at_s(result, times);
    return found.empty() ? 0.0 : found.back();
  }
  throw ArgumentError(fmt::format("'{}' is not measured; allowed: {}", measure, fmt::join(measures(), ", ")));
}

std::vector<double> found_at_s(const TrialResult& result, const report::SegmentationTimes& times) {
  std::vector<double> moments;
  for (const FoundObject& o : result.objects) {
    if (o.found) moments.push_back(recomputed(o, times, result.trial.method));
  }
  std::sort(moments.begin(), moments.end());
  return moments;
}

const Sample* Cell::sample(std::string_view method) const {
  const auto found = std::find_if(samples.begin(), samples.end(), [&](const Sample& s) { return s.method == method; });
  return found == samples.end() || found->values.empty() ? nullptr : &*found;
}

Cell cell_of(const std::vector<TrialResult>& results, const std::string& world, int objects,
             const std::string& measure) {
  Cell cell{world, measure, objects, {}};
  for (const TrialResult& result : results) {
    if (result.trial.world != world || result.trial.objects != objects) continue;
    auto sample = std::find_if(cell.samples.begin(), cell.samples.end(),
                               [&](const Sample& s) { return s.method == result.trial.method; });
    if (sample == cell.samples.end()) sample = cell.samples.insert(sample, {result.trial.method, {}, {}});
    sample->seeds.push_back(result.trial.seed);
    sample->values.push_back(measured(result, measure));
  }
  return cell;
}

std::vector<Cell> cells_of(const Spec& spec, const std::vector<TrialResult>& results) {
  std::vector<Cell> cells;
  for (const std::string& world : spec.worlds) {
    for (const int objects : spec.objects) {
      for (const std::string& measure : measures()) cells.push_back(cell_of(results, world, objects, measure));
    }
  }
  return cells;
}

Described described(const std::vector<double>& values, const std::string& stream) {
  constexpr std::uint64_t kSeed = 1;  // the same data, the same interval: whatever the seeds of the trials
  RandomStream random(kSeed, stream);
  Described d;
  d.n = static_cast<int>(values.size());
  d.mean = std::accumulate(values.begin(), values.end(), 0.0) / d.n;
  d.quartiles = quartiles(values);
  d.median_95 = bootstrap_median(values, random);
  return d;
}

Described described(const Cell& cell, const Sample& sample) {
  return described(sample.values,
                   fmt::format("bootstrap/{}/{}/{}/{}", cell.world, cell.objects, cell.measure, sample.method));
}

std::optional<Comparison> compared(const Cell& cell) {
  const Sample* slow = cell.sample(report::kStatic);
  const Sample* fast = cell.sample(report::kDynamic);
  if (slow == nullptr || fast == nullptr) return std::nullopt;
  std::vector<double> differences, of_static, of_dynamic;
  for (std::size_t i = 0; i < slow->seeds.size(); ++i) {
    const auto other = std::find(fast->seeds.begin(), fast->seeds.end(), slow->seeds[i]);
    if (other == fast->seeds.end()) continue;
    const double a = slow->values[i], b = fast->values[static_cast<std::size_t>(other - fast->seeds.begin())];
    of_static.push_back(a);
    of_dynamic.push_back(b);
    differences.push_back(a == b ? 0.0 : rounded(a - b));
  }
  if (differences.empty()) return std::nullopt;
  const std::string stream = fmt::format("bootstrap/{}/{}/{}/difference", cell.world, cell.objects, cell.measure);
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  return Comparison{described(differences, stream), wilcoxon(differences),
                    quantile(of_static, 0.5) / quantile(of_dynamic, 0.5), sum(of_static) / sum(of_dynamic)};
}

}  // namespace amiss::experiment
