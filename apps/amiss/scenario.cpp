#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <iostream>
#include <memory>
#include <mutex>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "interrupt.hpp"
#include "resources.hpp"
#include "scenario_jobs.hpp"
#include "scenario_random.hpp"
#include "scenario_report.hpp"
#include "scenario_run.hpp"
#include "scenario_view.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kLimit{600};  // of one run, on the clock; what takes longer hangs
constexpr std::size_t kMostOutput = std::size_t{64} << 20U;

struct Arguments {
  std::vector<std::string> files;
  std::string junit, out;
  int parallel = 2;
  bool prove = false, quiet = false;
  RandomScenarios random;
  bool write_only = false;
  ViewOptions view;
  int child = -2;  // which break a child runs; -1 none
};

/// Folders stand for the scenarios in them, sorted.
std::vector<fs::path> expanded(const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  for (const std::string& name : names) {
    if (!fs::is_directory(name)) {
      files.emplace_back(name);
      continue;
    }
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(name)) {
      if (entry.path().extension() == ".yaml") inside.push_back(entry.path());
    }
    std::sort(inside.begin(), inside.end());
    if (inside.empty()) throw InputError(name + ": no scenario (*.yaml) is in this folder");
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

int run_child(const Arguments& a) {
  catch_interrupts();
  try {
    const auto scenario = scenario::load_scenario(a.files.at(0), vocabulary_of(find_resources()));
    std::cout << run_job(scenario, a.child, false, a.out);
    return kGoalMet;
  } catch (const ArgumentError&) {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& e) {
    std::cerr << "amiss: " << e.what() << "\n";
    return kProgramFailed;
  }
}

/// The file of a job's log and picture, without the ending.
fs::path kept_at(const Arguments& a, const ScenarioJob& job) {
  if (a.out.empty()) return {};
  return fs::path(a.out) /
         (job.file.stem().string() + (job.break_index < 0 ? "" : "-broken-" + std::to_string(job.break_index + 1)));
}

std::vector<std::string> words_of(const Arguments& a, const ScenarioJob& job) {
  std::vector<std::string> words{own_program(), "scenario", job.file.string(), "--child",
                                 std::to_string(job.break_index)};
  if (!a.out.empty()) words.insert(words.end(), {"--out", kept_at(a, job).string()});
  return words;
}

/// What a run does wrong ends its child alone.
JobResult run_in_child(const Arguments& a, const ScenarioJob& job) {
  const auto began = std::chrono::steady_clock::now();
  const auto passed = [&] { return std::chrono::steady_clock::now() - began; };
  const auto stop = [&] { return interrupted() || passed() > kLimit; };
  JobResult result = judge_job(job, experiment::run_program(words_of(a, job), "", stop, kMostOutput));
  result.wall_s = std::chrono::duration<double>(passed()).count();
  result.finished = !interrupted();
  return result;
}

/// `ended`: what is done about each that finished, one at a time.
std::vector<JobResult> run_jobs(const Arguments& a, const std::vector<ScenarioJob>& jobs,
                                const std::function<void(std::size_t, JobResult&)>& ended) {
  std::vector<JobResult> results(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) results[i].job = jobs[i];
  std::atomic<std::size_t> next = 0;
  std::mutex printing;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size() && !interrupted(); i = next++) {
      results[i] = run_in_child(a, jobs[i]);
      const std::lock_guard lock(printing);
      if (!results[i].finished) continue;
      ended(i, results[i]);
      if (!a.quiet) std::cout << line_of(results[i]) << std::flush;
    }
  };
  std::vector<std::future<void>> workers;
  for (int i = 0; i < a.parallel; ++i) workers.push_back(std::async(std::launch::async, work));
  for (std::future<void>& worker : workers) worker.get();
  return results;
}

/// The worst of all: a program that failed, then a wrong scenario, then an expectation.
int status_of(const std::vector<JobResult>& results) {
  int worst = kGoalMet;
  for (const JobResult& r : results) worst = std::max(worst, r.exit_status);
  return interrupted() ? kInterrupted : worst;
}

int run_files(const Arguments& a) {
  std::vector<ScenarioJob> jobs;
  const scenario::Vocabulary words = vocabulary_of(find_resources());
  for (const fs::path& file : expanded(a.files)) {
    const scenario::Scenario scenario = scenario::load_scenario(file, words);
    if (a.prove && scenario.breaks.empty()) throw InputError(file.string() + ": --prove needs 'breaks'");
    const auto own = jobs_of(scenario, a.prove);
    jobs.insert(jobs.end(), own.begin(), own.end());
  }
  if (!a.out.empty()) fs::create_directories(a.out);
  const std::vector<JobResult> results = run_jobs(a, jobs, [](std::size_t, JobResult&) {});
  const auto good = std::count_if(results.begin(), results.end(),
                                  [](const JobResult& r) { return r.finished && r.exit_status == 0; });
  if (!a.quiet) std::cout << good << " of " << results.size() << " as expected\n";
  if (!a.junit.empty()) save_atomically(a.junit, report::to_junit("scenarios", junit_of(results)));
  if (!a.out.empty()) {
    std::vector<fs::path> kept;
    for (const ScenarioJob& job : jobs) kept.push_back(kept_at(a, job));
    save_atomically(fs::path(a.out) / "report.html", scenarios_page(results, kept));
  }
  return status_of(results);
}

constexpr std::array kEndings{".yaml", ".log", ".png"};

/// What an earlier run kept of a scenario that holds now.
void forget(const scenario::Scenario& scenario, const fs::path& folder) {
  for (const char* ending : kEndings) fs::remove(folder / (scenario.name + ending));
}

/// The file, log and floor plan of a scenario that failed.
void keep_failed(const scenario::Scenario& scenario, JobResult& result, const fs::path& folder) {
  const fs::path judged = save_random_scenario(scenario, folder);
  for (const char* ending : kEndings) {
    const fs::path made = fs::path(result.job.file).replace_extension(ending);
    if (ending != kEndings[0] && fs::exists(made)) fs::rename(made, fs::path(judged).replace_extension(ending));
  }
  result.job.file = judged;
}

/// What stands in the folder failed: each scenario waits in a folder of its own until it is judged.
int run_random(Arguments a) {
  const fs::path folder =
      a.out.empty() ? fs::path("runs") / ("random-" + std::to_string(a.random.seed)) : fs::path(a.out);
  const fs::path waiting = folder / "not_judged";
  fs::remove_all(waiting);
  a.out = waiting.string();
  const std::vector<scenario::Scenario> scenarios = random_scenarios(a.random);
  std::vector<ScenarioJob> jobs;
  for (const scenario::Scenario& s : scenarios) {
    jobs.push_back({save_random_scenario(s, a.write_only ? folder : waiting), -1, s.name, {}});
  }
  if (a.write_only) return kGoalMet;
  std::size_t finished = 0, failed = 0;
  const std::vector<JobResult> results = run_jobs(a, jobs, [&](std::size_t i, JobResult& result) {
    ++finished;
    if (result.exit_status == kGoalMet) return forget(scenarios[i], folder);
    ++failed;
    keep_failed(scenarios[i], result, folder);
  });
  fs::remove_all(waiting);
  if (!a.junit.empty()) save_atomically(a.junit, report::to_junit("random scenarios", junit_of(results)));
  if (!a.quiet) {
    std::cout << failed << " of " << finished << " failed; kept in " << folder.string() << "\n";
    if (finished < results.size()) std::cout << results.size() - finished << " did not finish\n";
  }
  return status_of(results);
}

int run_watched(const Arguments& a) {
  if (a.files.size() != 1 || fs::is_directory(a.files.front()) || a.prove || a.random.count > 0 || !a.junit.empty()) {
    throw ArgumentError("--view shows one run: one scenario file, without --prove, --junit and --random");
  }
  return view_scenario(a.files.front(), a.out, a.view, a.quiet);
}

int run_parent(const Arguments& a) {
  catch_interrupts();
  if (a.view.wanted) return run_watched(a);
  if (a.random.count > 0 && !a.files.empty()) throw ArgumentError("--random and files exclude each other");
  if (a.random.count > 0 && a.prove) throw ArgumentError("--random and --prove exclude each other");
  if (a.random.count > 0) return run_random(a);
  if (a.files.empty()) throw ArgumentError("scenario files are needed, or --random N");
  return run_files(a);
}

}  // namespace

void add_scenario_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("scenario", "scripted runs: what happens meanwhile, and what must come of it");
  command->add_option("files", a->files, "scenario files, or folders of them")->type_name("FILE");
  command->add_flag("--prove", a->prove, "also break each scenario as its file says, and see that it fails");
  command->add_option("--junit", a->junit, "write the results to this file, as JUnit XML")->type_name("FILE");
  command->add_option("-j,--jobs", a->parallel, "runs at the same time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command
      ->add_option("--out", a->out,
                   "keep a log and a floor plan of each run in this folder; with --view, the run folder")
      ->type_name("DIR");
  CLI::Option* random =
      command->add_option("--random", a->random.count, "so many scenarios by chance; those that fail are kept in --out")
          ->check(CLI::Range(1, 100000));
  command->add_option("--seed", a->random.seed, "of --random: the same seed, the same files")
      ->needs(random)
      ->capture_default_str();
  command->add_option("--world", a->random.world, "of --random: a name or an SDF file")
      ->needs(random)
      ->capture_default_str();
  command->add_flag("--write-only", a->write_only, "of --random: write the files and run none")->needs(random);
  add_view_options(*command, a->view, true);
  command->add_flag("--quiet", a->quiet, "the exit status alone");
  command->add_option("--child", a->child)->group("");  // what runs one scenario for the others
  command->callback([a, &exit_status] { exit_status = a->child >= -1 ? run_child(*a) : run_parent(*a); });
}

}  // namespace amiss::app
