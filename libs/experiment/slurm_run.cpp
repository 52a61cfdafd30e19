#include "experiment/slurm_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <thread>

#include "experiment/process.hpp"
#include "experiment/rounds.hpp"

namespace amiss::experiment {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenLooks(500);  // at the results
constexpr int kMostRefusals = 60;                        // one after the other, once something was accepted

class SlurmRun {
 public:
  SlurmRun(const Folder& folder, const std::string& program, const SlurmOptions& options, const RunHooks& hooks)
      : folder_(folder),
        hooks_(hooks),
        poll_(options.poll),
        jobs_(folder, program, options,
              [&hooks](const std::vector<std::string>& words) { return run_program(words, "", hooks.stop); }),
        all_(folder.missing().size()) {}

  RoundEnd round(const std::vector<Trial>& missing) {
    if (!hand_over(missing) || !watch()) return {true, ""};
    const auto left = folder_.missing();
    return {false, left.empty() ? "" : jobs_.last_words(left.front())};
  }
  [[nodiscard]] const SlurmJobs& jobs() const { return jobs_; }

 private:
  /// Nothing when Slurm does not answer, which is told once.
  std::optional<std::vector<QueuedTask>> ask_queue() {
    try {
      auto queue = jobs_.queue();
      silent_ = false;
      return queue;
    } catch (const SlurmError& e) {
      if (!silent_ && !hooks_.stop()) hooks_.tell(fmt::format("{}; waiting for Slurm to answer", e.what()));
      silent_ = true;
      return std::nullopt;
    }
  }

  /// False when it was stopped.
  bool hand_over(const std::vector<Trial>& missing) {
    for (int refusals = 0; !hooks_.stop(); pause()) {
      const auto queue = ask_queue();
      if (!queue) continue;
      accepted_ = accepted_ || !queue->empty();
      const auto trials = jobs_.without(missing, *queue);
      if (trials.empty()) return true;
      try {
        const std::string refused = jobs_.submit(trials);
        if (!refused.empty()) hooks_.tell(refused + "; the rest is handed over when what was taken is done");
        accepted_ = true;
        return true;
      } catch (const SlurmError& e) {
        if (hooks_.stop()) return false;
        if (!accepted_ || ++refusals == kMostRefusals) throw;
        if (refusals == 1) hooks_.tell(fmt::format("{}; trying again", e.what()));
      }
    }
    return false;
  }

  /// Until nothing is in the queue or nothing is missing. False when it was stopped.
  bool watch() {
    for (Clock::time_point asked_at; !hooks_.stop(); pause()) {
      const std::size_t missing = folder_.missing().size();
      hooks_.progress(all_ - missing, all_);
      if (missing == 0) return true;
      if (Clock::now() - asked_at < poll_) continue;
      const auto queue = ask_queue();
      if (queue && queue->empty()) return true;
      if (queue) tell_why_nothing_runs(*queue);
      asked_at = Clock::now();
    }
    return false;
  }

  void tell_why_nothing_runs(const std::vector<QueuedTask>& queue) {
    const std::set<std::string> passing{"None", "Priority", "Resources", "BeginTime"};
    const bool any_runs = std::any_of(queue.begin(), queue.end(), [](const QueuedTask& t) { return t.runs; });
    const std::string& reason = queue.front().reason;
    if (any_runs || passing.contains(reason) || reason == reason_told_) return;
    reason_told_ = reason;
    hooks_.tell("no task runs; Slurm's reason is " + reason);
  }

  void pause() const { std::this_thread::sleep_for(std::min(kBetweenLooks, poll_)); }

  const Folder& folder_;
  const RunHooks& hooks_;
  std::chrono::milliseconds poll_;
  SlurmJobs jobs_;
  std::size_t all_;
  bool accepted_ = false;  // that Slurm takes what we hand over, at least sometimes
  bool silent_ = false;
  std::string reason_told_;
};

void tell_what_stays(const SlurmJobs& jobs, const RunHooks& hooks) {
  hooks.tell(
      fmt::format("what is in Slurm's queue stays there; the same call takes it up again, `scancel --name={}` ends it",
                  fmt::join(jobs.names(), ",")));
}

}  // namespace

bool run_on_slurm(const Folder& folder, const std::string& program, const SlurmOptions& options,
                  const RunHooks& hooks) {
  if (folder.missing().empty()) {
    remove_scripts(folder);
    return true;
  }
  SlurmRun run(folder, program, options, hooks);
  const bool done = run_rounds(
      folder, [&](const std::vector<Trial>& missing) { return run.round(missing); }, hooks);
  if (done) run.jobs().forget();
  if (!done && hooks.stop()) tell_what_stays(run.jobs(), hooks);
  return done;
}

}  // namespace amiss::experiment
