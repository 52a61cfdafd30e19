// The trials of an experiment as tables: Folder -> a row for each trial, and all that is made of them. All but
// clock_table are functions of the results alone and the same however often the experiment was interrupted and however
// many trials ran at a time.
#pragma once

#include <map>
#include <string>

#include "experiment/folder.hpp"
#include "experiment/table.hpp"

namespace amiss::experiment {

/// Every planned trial: done, failed (with why) or missing.
[[nodiscard]] Table results_table(const std::vector<Trial>& trials, const std::vector<TrialResult>& results);
/// What took how long on the clock, of those that told.
[[nodiscard]] Table clock_table(const Folder& folder);

/// results.tsv, summary.tsv and statistics.tsv by name: what verification makes again.
[[nodiscard]] std::map<std::string, std::string> merged_files(const Folder& folder);

}  // namespace amiss::experiment
