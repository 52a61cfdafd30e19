// The trials of the evaluation of chapter 5: every method on every annotated visit of a data set in ObChange's layout.
// A trial leaves OUT/trials/<room>/scene<N>/<method>.json and .png; one that is there and was made of the same bytes by
// the same program with the same parameters is not done again.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dataset/room_folders.hpp"
#include "detect_settings.hpp"
#include "score/novel_score.hpp"

namespace amiss::app {

struct Visit {
  std::string room;
  dataset::SceneFiles reference, current;
};

/// All scenes that have annotations, against scene1 of their room. `left_out`: why the others are not among them.
struct VisitList {
  std::vector<Visit> visits;
  std::vector<std::string> left_out;
};
[[nodiscard]] VisitList annotated_visits(const std::filesystem::path& dataset);

struct TrialResult {
  score::NovelTrial trial;
  std::size_t objects = 0, clusters = 0;
  std::string labels, space;
  std::vector<std::string> missed;  // names of objects
  double wall_s = 0.0;              // of the detection; a method's own part and what all methods share
  bool done_before = false;
  std::string scene;
  std::filesystem::path picture;  // from above, what was found
};

/// The methods on one visit. `labelled_only`: methods that need labels are left out where there are none.
[[nodiscard]] std::vector<TrialResult> run_trials(const Visit& visit, const std::vector<std::string>& methods,
                                                  const DetectSettings& settings, bool labelled_only,
                                                  const std::filesystem::path& out);

}  // namespace amiss::app
