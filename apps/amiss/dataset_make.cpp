#include "dataset_make.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <iostream>
#include <mutex>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset_jobs.hpp"
#include "dataset_report.hpp"
#include "experiment/process.hpp"
#include "interrupt.hpp"
#include "time_left.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFormat = "dataset 1";
constexpr double kGuess_s = 60.0;  // of a job

/// What a data set in this folder is made of; a folder of another one is refused.
void claim(const fs::path& folder, const DatasetOptions& options, DatasetSettings& settings) {
  const std::string text =
      fmt::format("# {}, amiss {}\n# seed {}\n{}", kFormat, AMISS_VERSION, options.seed, settings.table().to_yaml());
  const fs::path file = folder / "dataset.yaml";
  if (!fs::exists(file)) {
    if (fs::exists(folder) && !fs::is_empty(folder)) {
      throw ArgumentError(folder.string() + ": holds something else; a new or empty folder is needed");
    }
    fs::create_directories(folder);
    save_atomically(file, text);
  } else if (load_bytes(file) != text) {
    throw ArgumentError(file.string() +
                        ": made with another seed, other parameters or another version; another folder or the same "
                        "ones are needed");
  }
}

std::vector<std::string> words_of(const DatasetOptions& options, const std::string& job) {
  std::vector<std::string> words{
      own_program(), "dataset", "make", "--out", options.out, "--seed", std::to_string(options.seed), "--child", job};
  if (!options.rawlog) words.emplace_back("--no-rawlog");
  if (!options.params_file.empty()) words.insert(words.end(), {"--params", options.params_file});
  for (const std::string& assignment : options.overrides) words.insert(words.end(), {"--set", assignment});
  return words;
}

/// The jobs as child processes, some at a time. Tells how far they are, and of each that failed why.
class Work {
 public:
  Work(const DatasetOptions& options, std::vector<std::string> jobs, const std::string& what)
      : options_(options), jobs_(std::move(jobs)), time_left_(kGuess_s, what) {}

  /// The worst exit status.
  int run() {
    if (!options_.quiet && !jobs_.empty()) time_left_.show(0, jobs_.size());
    std::vector<std::future<void>> workers;
    for (int i = 0; i < options_.jobs; ++i) workers.push_back(std::async(std::launch::async, [this] { work(); }));
    for (std::future<void>& worker : workers) worker.get();
    time_left_.clear();
    return interrupted() ? kInterrupted : worst_;
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < jobs_.size() && !interrupted(); i = next_++) {
      const experiment::Ended child = experiment::run_program(words_of(options_, jobs_[i]), "", interrupted);
      const std::lock_guard lock(telling_);
      ended(jobs_[i], child);
    }
  }
  void ended(const std::string& job, const experiment::Ended& child) {
    const int status = child.signal != 0 ? kProgramFailed : child.status;
    worst_ = std::max(worst_, status);
    ++done_;
    if (status != kGoalMet && !interrupted()) {
      time_left_.clear();
      std::cerr << "amiss: " << job << ": "
                << (child.signal != 0 ? fmt::format("the program crashed (signal {})\n", child.signal) : child.err);
    }
    if (!options_.quiet) time_left_.show(done_, jobs_.size());
  }

  const DatasetOptions& options_;
  std::vector<std::string> jobs_;
  TimeLeft time_left_;
  std::mutex telling_;
  std::atomic<std::size_t> next_ = 0;
  std::size_t done_ = 0;
  int worst_ = kGoalMet;
};

}  // namespace

int make_dataset(const DatasetOptions& options) {
  catch_interrupts();
  DatasetSettings settings = load_dataset_settings(options.params_file, options.overrides);
  const DatasetJobs jobs(options.out, settings, options.seed, options.rawlog);
  if (!options.child.empty()) return jobs.run(options.child);
  const auto plans = chosen_rooms(find_resources(), options.rooms, options.visits);
  claim(options.out, options, settings);
  int status = Work(options, jobs.preparations(plans), "maps and placements").run();
  for (const std::string& shortfall : jobs.shortfalls(plans)) std::cerr << "amiss: " << shortfall << "\n";
  if (status == kGoalMet) status = Work(options, jobs.visits(plans), "visits").run();
  if (status != kGoalMet) return status;
  const std::string summary = jobs.summary(plans);
  save_dataset_report(options.out, summary, settings.table().to_yaml(), jobs.recordings(plans));
  if (!options.quiet) std::cout << summary << " in " << options.out << "/recordings\n";
  return kGoalMet;
}

}  // namespace amiss::app
