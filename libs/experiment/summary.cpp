#include "experiment/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace amiss::experiment {

namespace {

using Row = std::vector<std::string>;

void append(Row& row, const Row& more) { row.insert(row.end(), more.begin(), more.end()); }

/// A batch of one method.
struct Batch {
  std::string world, method;
  int objects = 0, trials = 0, all_found = 0, not_all = 0, failed = 0;
  std::vector<TrialResult> results;

  [[nodiscard]] int missing() const { return trials - static_cast<int>(results.size()); }
  [[nodiscard]] Row head() const {
    Row row{world, std::to_string(objects), method};
    for (const int count : {trials, all_found, not_all, failed, missing()}) row.push_back(std::to_string(count));
    return row;
  }
  /// Segmentation actions for an object, over all trials that found all.
  [[nodiscard]] double actions_an_object() const {
    double actions = 0.0, placed = 0.0;
    for (const TrialResult& r : results) {
      if (!r.complete()) continue;
      actions += r.segmentations;
      placed += r.placed;
    }
    return actions / placed;
  }
  [[nodiscard]] std::optional<Quartiles> of(const std::string& measure) const {
    const Cell cell = cell_of(results, world, objects, measure);
    const Sample* sample = cell.sample(method);
    return sample == nullptr ? std::nullopt : std::optional(quartiles(sample->values));
  }
};

const Row kBatchHead{"world", "objects", "method", "trials", "all_found", "not_all", "failed", "missing"};

std::vector<Batch> batches_of(const std::vector<Trial>& trials, const std::vector<TrialResult>& results) {
  std::vector<Batch> batches;
  for (const Trial& t : trials) {
    auto batch = std::find_if(batches.begin(), batches.end(), [&](const Batch& b) {
      return b.world == t.world && b.method == t.method && b.objects == t.objects;
    });
    if (batch == batches.end()) batch = batches.insert(batch, Batch{t.world, t.method, t.objects, 0, 0, 0, 0, {}});
    ++batch->trials;
    const auto result = std::find_if(results.begin(), results.end(), [&](const auto& r) { return r.trial == t; });
    if (result == results.end()) continue;
    batch->results.push_back(*result);
    ++(result->failed ? batch->failed : (result->complete() ? batch->all_found : batch->not_all));
  }
  return batches;
}

std::string rough(double value) { return std::isfinite(value) ? fmt::format("{:.1f}", value) : number_text(value); }

std::string rough(const std::optional<Quartiles>& q) {
  return q ? fmt::format("{} ({} .. {})", rough(q->median), rough(q->q1), rough(q->q3)) : "-";
}

Row fields(const std::optional<Described>& d) {
  if (!d) return {"0", "-", "-", "-", "-", "-", "-"};
  Row row{std::to_string(d->n)};
  for (const double value :
       {d->mean, d->quartiles.median, d->quartiles.q1, d->quartiles.q3, d->median_95.low, d->median_95.high}) {
    row.push_back(number_text(value));
  }
  return row;
}

std::optional<Described> described(const Cell& cell, std::string_view method) {
  const Sample* sample = cell.sample(method);
  return sample == nullptr ? std::nullopt : std::optional(described(cell, *sample));
}

std::string p_text(double p) { return fmt::format("{:.6g}", p); }

}  // namespace

Table summary_table(const std::vector<Trial>& trials, const std::vector<TrialResult>& results) {
  Table table{kBatchHead, {}};
  append(table.heading, {"segmentations_an_object", "regions", "false_regions", "collisions"});
  for (const std::string& measure : measures()) {
    for (const char* what : {"_median", "_q1", "_q3"}) table.heading.push_back(measure + what);
  }
  for (const Batch& batch : batches_of(trials, results)) {
    Row row = batch.head();
    int regions = 0, false_regions = 0, collisions = 0;
    for (const TrialResult& r : batch.results) {
      regions += r.regions;
      false_regions += r.regions_false;
      collisions += r.collisions;
    }
    append(row, {number_text(batch.actions_an_object()), std::to_string(regions), std::to_string(false_regions),
                 std::to_string(collisions)});
    for (const std::string& measure : measures()) {
      const auto q = batch.of(measure);
      append(row, q ? Row{number_text(q->median), number_text(q->q1), number_text(q->q3)} : Row{"-", "-", "-"});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table short_summary(const std::vector<Trial>& trials, const std::vector<TrialResult>& results) {
  Table table{kBatchHead, {}};
  append(table.heading, {"segmentations/object"});
  append(table.heading, measures());
  for (const Batch& batch : batches_of(trials, results)) {
    Row row = batch.head();
    const double actions = batch.actions_an_object();
    row.push_back(std::isfinite(actions) ? fmt::format("{:.2f}", actions) : "-");
    for (const std::string& measure : measures()) row.push_back(rough(batch.of(measure)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table statistics_table(const Spec& spec, const std::vector<TrialResult>& results) {
  Table table{{"world", "objects", "measure"}, {}};
  for (const std::string who : {"dynamic", "static", "difference"}) {
    for (const char* what : {"_n", "_mean", "_median", "_q1", "_q3", "_low95", "_high95"}) {
      table.heading.push_back(who + what);
    }
  }
  append(table.heading,
         {"ratio_of_medians", "ratio_of_means", "zeros", "w_plus", "w_minus", "p", "p_is", "rank_biserial"});
  for (const Cell& cell : cells_of(spec, results)) {
    Row row{cell.world, std::to_string(cell.objects), cell.measure};
    append(row, fields(described(cell, report::kDynamic)));
    append(row, fields(described(cell, report::kStatic)));
    const auto c = compared(cell);
    append(row, fields(c ? std::optional(c->difference) : std::nullopt));
    append(row, c ? Row{number_text(c->ratio_of_medians), number_text(c->ratio_of_means), std::to_string(c->test.zeros),
                        number_text(c->test.w_plus), number_text(c->test.w_minus), p_text(c->test.p),
                        c->test.exact ? "exact" : "normal", number_text(c->test.effect)}
                  : Row(8, "-"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table short_statistics(const Spec& spec, const std::vector<TrialResult>& results) {
  Table table{{"world", "objects", "measure", "pairs", "dynamic", "static", "ratio", "static - dynamic (95 %)", "p",
               "rank-biserial"},
              {}};
  for (const Cell& cell : cells_of(spec, results)) {
    const auto c = compared(cell);
    if (!c) continue;
    table.rows.push_back({cell.world, std::to_string(cell.objects), cell.measure, std::to_string(c->difference.n),
                          rough(quartiles(cell.sample(report::kDynamic)->values)),
                          rough(quartiles(cell.sample(report::kStatic)->values)),
                          std::isfinite(c->ratio_of_medians) ? fmt::format("{:.2f}", c->ratio_of_medians)
                                                             : number_text(c->ratio_of_medians),
                          fmt::format("{} ({} .. {})", rough(c->difference.quartiles.median),
                                      rough(c->difference.median_95.low), rough(c->difference.median_95.high)),
                          fmt::format("{:.4f}", c->test.p), fmt::format("{:.2f}", c->test.effect)});
  }
  return table;
}

}  // namespace amiss::experiment
