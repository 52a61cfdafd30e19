// Who does the trials of an experiment: this program, the job arrays of a Slurm cluster, GNU parallel.
#pragma once

#include "experiment/folder.hpp"
#include "experiment_run.hpp"

namespace amiss::app {

/// ArgumentError for an option that belongs to another engine.
void check_engine(const ExperimentOptions& options);
/// On standard output, and nothing else; an exit status.
int print_scripts(const experiment::Folder& folder, const ExperimentOptions& options);
/// What is missing, with a line of progress on standard error; ends early when interrupted or given up.
void do_trials(const experiment::Folder& folder, const ExperimentOptions& options);

}  // namespace amiss::app
