// What is missing of an experiment goes out to others in rounds, until nothing is missing or nothing comes of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiment/folder.hpp"
#include "experiment/runner.hpp"

namespace amiss::experiment {

struct RoundEnd {
  bool stopped = false;    // because it was asked to
  std::string last_words;  // of what went wrong
};

/// `round` hands these trials out and waits until no more comes of it. Three in a row without one new result are the
/// end, which is told. True when nothing is missing.
bool run_rounds(const Folder& folder, const std::function<RoundEnd(const std::vector<Trial>& missing)>& round,
                const RunHooks& hooks);

}  // namespace amiss::experiment
