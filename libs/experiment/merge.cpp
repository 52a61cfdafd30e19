#include "experiment/merge.hpp"

#include <algorithm>

#include "experiment/comparison.hpp"
#include "experiment/summary.hpp"

namespace amiss::experiment {

namespace {

using Row = std::vector<std::string>;

const TrialResult* result_of(const std::vector<TrialResult>& results, const Trial& trial) {
  const auto found = std::find_if(results.begin(), results.end(), [&](const auto& r) { return r.trial == trial; });
  return found == results.end() ? nullptr : &*found;
}

void append(Row& row, const Row& more) { row.insert(row.end(), more.begin(), more.end()); }

const Row kKept{"outcome",        "placed",      "found",         "segmentations", "segments",
                "false_segments", "regions",     "false_regions", "collisions",    "failed_actions",
                "view_triangles", "simulated_s", "driving_s",     "distance_m",    "segmentation_cost_s"};

Row kept(const TrialResult& r) {
  return {r.outcome,
          std::to_string(r.placed),
          std::to_string(r.found),
          std::to_string(r.segmentations),
          std::to_string(r.segments),
          std::to_string(r.segments_false),
          std::to_string(r.regions),
          std::to_string(r.regions_false),
          std::to_string(r.collisions),
          std::to_string(r.failed_actions),
          std::to_string(r.view_triangles),
          number_text(r.simulated_s),
          number_text(r.driving_s),
          number_text(r.distance_m),
          number_text(r.segmentation_cost_s)};
}

}  // namespace

Table results_table(const std::vector<Trial>& trials, const std::vector<TrialResult>& results) {
  Table table{{"id", "world", "method", "objects", "seed", "scatter_seed", "program", "status"}, {}};
  append(table.heading, kKept);
  append(table.heading, measures());
  append(table.heading, {"digest", "why"});
  for (const Trial& t : trials) {
    const TrialResult* r = result_of(results, t);
    const bool done = r != nullptr && !r->failed;
    Row row{t.id,
            t.world,
            t.method,
            std::to_string(t.objects),
            std::to_string(t.seed),
            std::to_string(t.scatter_seed),
            t.program,
            r == nullptr ? "missing" : (done ? "done" : "failed")};
    append(row, done ? kept(*r) : Row(kKept.size(), "-"));
    for (const std::string& measure : measures()) row.push_back(done ? number_text(measured(*r, measure)) : "-");
    append(row, {done ? r->digest : "-", r != nullptr && r->failed ? r->why : "-"});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table clock_table(const Folder& folder) {
  Table table{{"id", "wall_s", "segmentation_mean_ms", "differencing_mean_ms"}, {}};
  for (const Trial& trial : folder.trials()) {
    if (const auto times = folder.times(trial)) {
      table.rows.push_back({trial.id, number_text(times->wall_s), number_text(times->segmentation_mean_ms),
                            number_text(times->differencing_mean_ms)});
    }
  }
  return table;
}

std::map<std::string, std::string> merged_files(const Folder& folder) {
  const auto results = folder.results();
  return {{"results.tsv", to_tsv(results_table(folder.trials(), results))},
          {"summary.tsv", to_tsv(summary_table(folder.trials(), results))},
          {"statistics.tsv", to_tsv(statistics_table(folder.spec(), results))}};
}

}  // namespace amiss::experiment
