// What an evaluation of chapter 5 leaves beside its trials: Table 5.2 as TSV, Markdown and a page, its averages as a
// figure, and a report. Over several reconstructions of the same rooms (5.3.6) the table has a column more,
// `reconstruction`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate_trials.hpp"
#include "experiment/table.hpp"

namespace amiss::app {

/// A data set and what came out on it.
struct JudgedRooms {
  std::string reconstruction;  // its name; empty where there is one data set
  std::string dataset;
  VisitList list;
  std::vector<TrialResult> results;
};

struct SavedTable {
  std::string title;
  std::vector<std::string> sentences;  // what the numbers rest on
  experiment::Table table;
};

/// Writes params.yaml, STEM.tsv, STEM.md, STEM.html, figures/, report.html and report.json. There is at least one
/// result.
[[nodiscard]] SavedTable save_tables(const std::vector<JudgedRooms>& judged, const DetectSettings& settings,
                                     const std::string& stem, const std::filesystem::path& out);

}  // namespace amiss::app
