#include "experiment_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "commands.hpp"
#include "core/result.hpp"
#include "experiment/file_lock.hpp"
#include "experiment/runner.hpp"
#include "experiment_engine.hpp"
#include "interrupt.hpp"
#include "resources.hpp"
#include "time_left.hpp"
#include "trial_basis.hpp"

namespace amiss::app {

namespace fs = std::filesystem;
using experiment::Folder;
using experiment::Trial;

namespace {

/// Held by the one `run` of a folder.
experiment::FileLock lock_of(const Folder& folder) {
  auto lock = experiment::FileLock::take(folder.path() / "lock");
  if (lock) return std::move(*lock);
  throw ArgumentError(folder.path().string() +
                      ": another `amiss experiment run` works in it; one at a time is allowed");
}

}  // namespace

int plan_experiment(const fs::path& spec_file, int jobs) {
  const experiment::Spec spec = experiment::load_spec(spec_file);
  const auto trials = experiment::trials_of(spec, trial_keys(spec), program_hash());
  std::cout << experiment::to_tsv(trials);
  const double wall_s = static_cast<double>(trials.size()) * spec.trial_wall_s / jobs;
  std::cerr << fmt::format("{} trials, about {} with {} at a time\n", trials.size(), duration_text(wall_s), jobs);
  return kGoalMet;
}

int run_experiment(const fs::path& spec_file, const ExperimentOptions& options) {
  catch_interrupts();
  check_engine(options);
  const experiment::Spec spec = experiment::load_spec(spec_file);
  const auto keys = trial_keys(spec);
  const auto trials = experiment::trials_of(spec, keys, program_hash());
  const fs::path out = options.out.empty() ? fs::path("runs") / spec_file.stem() : options.out;
  const Folder folder = Folder::begin(out, spec_file, trials);
  const experiment::FileLock lock = lock_of(folder);
  if (options.engine == kLocalEngine) folder.clear_work();  // else tasks of before may be at work still
  folder.save_basis(keys);
  if (options.print) return print_scripts(folder, options);
  if (options.retry_failed) folder.forget_failures();
  const auto tell = [](const std::string& world) { std::cerr << "amiss: mapping " << world << " once\n"; };
  if (!prepare_references(folder.spec(), tell)) return interrupted() ? kInterrupted : kGoalNotMet;
  do_trials(folder, options);
  return interrupted() ? kInterrupted : show_experiment(folder.path());
}

int work_on_experiment(const fs::path& path, const std::vector<std::string>& ids) {
  catch_interrupts();
  const Folder folder = Folder::open(path);
  experiment::RunHooks hooks;
  hooks.stop = interrupted;
  folder.require_program(program_hash());
  for (const std::string& id : ids) {
    if (!run_trial(folder, folder.trial(id), kRunningProgram, hooks)) return kInterrupted;
  }
  return kGoalMet;
}

int show_experiment(const fs::path& path) {
  const Folder folder = Folder::open(path);
  struct Count {
    int done = 0, failed = 0, incomplete = 0, missing = 0;
  };
  std::map<std::string, Count> counts;
  Count all;
  for (const Trial& trial : folder.trials()) {
    Count& count = counts[fmt::format("{:<12}{:<10}{:>3} objects", trial.world, trial.method, trial.objects)];
    if (!folder.has(trial)) {
      ++count.missing, ++all.missing;
      continue;
    }
    const experiment::TrialResult result = folder.result(trial);
    if (result.failed) {
      ++count.failed, ++all.failed;
      std::cerr << fmt::format("failed: {} ({} {} {} objects, seed {}): {}\n", trial.id, trial.world, trial.method,
                               trial.objects, trial.seed, result.why);
    } else if (result.complete()) {
      ++count.done, ++all.done;
    } else {
      ++count.incomplete, ++all.incomplete;
    }
  }
  const auto line = [](const std::string& name, const Count& c) {
    return fmt::format("{:<36}{:>6} all found{:>6} not all{:>6} failed{:>6} missing\n", name, c.done, c.incomplete,
                       c.failed, c.missing);
  };
  for (const auto& [name, count] : counts) std::cout << line(name, count);
  std::cout << line("all", all);
  return all.failed + all.missing == 0 ? kGoalMet : kGoalNotMet;
}

}  // namespace amiss::app
