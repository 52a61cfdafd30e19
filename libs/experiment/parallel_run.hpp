// The trials of an experiment done by GNU parallel, here or on machines that ssh reaches and that see the same files.
// What a killed run left behind goes on by itself, and its trials are not done a second time (Folder::claim).
#pragma once

#include <string>
#include <vector>

#include "experiment/folder.hpp"
#include "experiment/runner.hpp"

namespace amiss::experiment {

struct ParallelOptions {
  std::string command = "parallel";
  int chunk = 1;                    // trials for one call
  int jobs = 2;                     // calls at a time on each machine that says no number of its own
  std::vector<std::string> logins;  // as --sshlogin takes them; none: this machine
};

/// What is missing, in rounds (rounds.hpp). `program`: the file of amiss, on all machines. True when nothing is
/// missing, false when it was stopped or given up; ArgumentError when there is no GNU parallel.
bool run_in_parallel(const Folder& folder, const std::string& program, const ParallelOptions& options,
                     const RunHooks& hooks);

}  // namespace amiss::experiment
