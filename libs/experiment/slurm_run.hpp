// The trials of an experiment done by the job arrays of a Slurm cluster whose machines see the same files: handed over,
// watched, collected, and handed over again where no result came back.
#pragma once

#include <string>

#include "experiment/folder.hpp"
#include "experiment/runner.hpp"
#include "experiment/slurm_jobs.hpp"

namespace amiss::experiment {

/// What is missing and not in the queue yet, in rounds (rounds.hpp). `program`: the file of amiss, on all machines.
/// True when nothing is missing; false when it was given up, or stopped: what is in the queue then stays there, which
/// is told. SlurmError when Slurm is not there or takes nothing. While it does not answer it is waited for.
bool run_on_slurm(const Folder& folder, const std::string& program, const SlurmOptions& options, const RunHooks& hooks);

}  // namespace amiss::experiment
