#include "experiment/runner.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "core/files.hpp"
#include "core/result.hpp"
#include "experiment/process.hpp"

namespace amiss::experiment {

namespace fs = std::filesystem;

namespace {

constexpr int kInterrupted = 130, kLastGoodStatus = 1;  // of `amiss tidy`
constexpr int kAttempts = 3;
constexpr std::chrono::milliseconds kBetweenProgress(500), kBetweenClaims(200);

std::string why_failed(const Ended& ended) {
  if (ended.signal != 0) return fmt::format("ended by signal {}", ended.signal);
  return fmt::format("status {}: {}", ended.status, last_line(ended.err));
}

/// A child that was killed from outside is started again: when a machine goes down its processes die one by one, and a
/// trial must not be called failed because its child died first.
Ended patiently(const std::vector<std::string>& words, const RunHooks& hooks) {
  Ended ended;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    ended = run_program(words, "", hooks.stop);
    if (ended.signal != SIGKILL && ended.signal != SIGTERM && ended.signal != SIGHUP) break;
  }
  return ended;
}

/// One run. False when it gave no result: it was stopped, or its folder was cleared away, which says nothing of the
/// trial. The program may make its folder again then, but not the mark above it.
bool attempt(const Folder& folder, const Trial& trial, const std::string& program, const RunHooks& hooks) {
  const fs::path work = folder.work_folder(trial);
  const fs::path run = work / "run", mark = work / "begun";
  fs::create_directories(mark);
  std::vector<std::string> words = arguments_of(trial, folder.spec(), run.string());
  words.insert(words.begin(), program);
  const Ended ended = patiently(words, hooks);
  const bool interrupted = ended.stopped || ended.status == kInterrupted || hooks.stop();
  const bool cleared = !fs::exists(mark);
  const fs::path report = run / "report.json";
  if (!interrupted && ended.signal == 0 && ended.status <= kLastGoodStatus && fs::exists(report)) {
    const std::string json = load_bytes(report);
    folder.save_result(trial, result_text(trial, json), times_text(json));
  } else if (!interrupted && !cleared) {
    folder.save_result(trial, failure_text(trial, why_failed(ended)), "");
  }
  std::error_code gone;
  fs::remove_all(work, gone);
  return !interrupted && !cleared;
}

}  // namespace

bool run_trial(const Folder& folder, const Trial& trial, const std::string& program, const RunHooks& hooks) {
  for (int tried = 0; !folder.has(trial);) {
    if (hooks.stop() || tried == kAttempts) return false;
    const auto claim = folder.claim(trial);
    if (!claim) {
      std::this_thread::sleep_for(kBetweenClaims);
    } else if (!folder.has(trial)) {
      if (attempt(folder, trial, program, hooks)) return true;
      ++tried;
    }
  }
  return true;
}

bool run_trials(const Folder& folder, const std::vector<Trial>& trials, int jobs, const std::string& program,
                const RunHooks& hooks) {
  std::atomic<std::size_t> next = 0, done = 0;
  std::atomic<bool> broken = false;
  RunHooks inner = hooks;
  inner.stop = [&] { return broken || hooks.stop(); };
  const auto work = [&] {
    for (std::size_t i = next++; i < trials.size() && !inner.stop(); i = next++) {
      try {
        if (run_trial(folder, trials[i], program, inner)) ++done;
      } catch (...) {
        broken = true;  // a full disk, for example: the others end too
        throw;
      }
    }
  };
  std::vector<std::future<void>> workers;
  for (int i = 0; i < jobs; ++i) workers.push_back(std::async(std::launch::async, work));
  for (std::future<void>& worker : workers) {
    while (worker.wait_for(kBetweenProgress) != std::future_status::ready) hooks.progress(done, trials.size());
  }
  for (std::future<void>& worker : workers) worker.get();
  hooks.progress(done, trials.size());
  return done == trials.size();
}

}  // namespace amiss::experiment
