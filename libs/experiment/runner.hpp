// Does trials: each is `amiss tidy` as a child with a folder of its own; its result is kept, or why it failed.
// Several at a time on this machine, or one after the other as the task of a cluster.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiment/folder.hpp"

namespace amiss::experiment {

struct RunHooks {
  std::function<bool()> stop = [] { return false; };
  /// A trial ended, or none since a second: how many results there are of these trials.
  std::function<void(std::size_t done, std::size_t of)> progress = [](std::size_t, std::size_t) {};
  std::function<void(const std::string& sentence)> tell = [](const std::string&) {};  // what a user should know
};

/// `program`: the file of amiss. A trial that was stopped leaves nothing; false then. One that another process does at
/// the moment is waited for.
bool run_trial(const Folder& folder, const Trial& trial, const std::string& program, const RunHooks& hooks);

/// Those of `trials` that have no result yet, `jobs` at a time. False when it was stopped.
bool run_trials(const Folder& folder, const std::vector<Trial>& trials, int jobs, const std::string& program,
                const RunHooks& hooks);

}  // namespace amiss::experiment
