#include "experiment_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "commands.hpp"
#include "core/result.hpp"
#include "experiment/parallel_run.hpp"
#include "experiment/process.hpp"
#include "experiment/runner.hpp"
#include "experiment/slurm_run.hpp"
#include "interrupt.hpp"
#include "resources.hpp"
#include "time_left.hpp"

namespace amiss::app {

using experiment::Folder;

namespace {

experiment::RunHooks hooks_of(TimeLeft& left) {
  experiment::RunHooks hooks;
  hooks.stop = interrupted;
  hooks.progress = [&left](std::size_t done, std::size_t of) { left.show(done, of); };
  hooks.tell = [&left](const std::string& sentence) {
    left.clear();
    std::cerr << "amiss: " << sentence << "\n";
  };
  return hooks;
}

experiment::SlurmOptions slurm_options(const ExperimentOptions& options) {
  experiment::SlurmOptions slurm;
  if (options.chunk > 0) slurm.chunk = options.chunk;
  slurm.at_a_time = options.jobs;
  slurm.sbatch = options.sbatch;
  return slurm;
}

}  // namespace

void check_engine(const ExperimentOptions& options) {
  const bool slurm = options.engine == kSlurmEngine, parallel = options.engine == kParallelEngine;
  if (options.print && !slurm) throw ArgumentError("--print: is allowed with --engine slurm");
  if (!options.sbatch.empty() && !slurm) throw ArgumentError("--sbatch: is allowed with --engine slurm");
  if (!options.logins.empty() && !parallel) throw ArgumentError("--sshlogin: is allowed with --engine parallel");
  if (options.chunk > 0 && !slurm && !parallel) {
    throw ArgumentError("--chunk: is allowed with --engine slurm and --engine parallel");
  }
}

/// Where there is no Slurm, for the size that arrays have by default.
int print_scripts(const Folder& folder, const ExperimentOptions& options) {
  int max_array_size = experiment::kUsualMaxArraySize;
  try {
    max_array_size = experiment::Slurm([](const auto& words) {
                       return experiment::run_program(words, "", interrupted);
                     }).max_array_size();
  } catch (const experiment::SlurmError& e) {
    std::cerr << fmt::format("amiss: {}; MaxArraySize is taken to be {}\n", e.what(), max_array_size);
  }
  for (const std::string& script :
       experiment::slurm_scripts(folder, folder.missing(), own_program(), slurm_options(options), max_array_size)) {
    std::cout << script;
  }
  return kGoalMet;
}

void do_trials(const Folder& folder, const ExperimentOptions& options) {
  constexpr int kUsualJobs = 2;
  const int jobs = options.jobs > 0 ? options.jobs : kUsualJobs;
  TimeLeft left(folder.spec().trial_wall_s / jobs);
  const experiment::RunHooks hooks = hooks_of(left);
  if (options.engine == kLocalEngine) {
    experiment::run_trials(folder, folder.missing(), jobs, kRunningProgram, hooks);
  } else if (options.engine == kParallelEngine) {
    experiment::run_in_parallel(folder, own_program(), {"parallel", std::max(1, options.chunk), jobs, options.logins},
                                hooks);
  } else {
    experiment::run_on_slurm(folder, own_program(), slurm_options(options), hooks);
  }
  left.clear();
}

}  // namespace amiss::app
