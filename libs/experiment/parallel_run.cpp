#include "experiment/parallel_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "core/result.hpp"
#include "experiment/array_script.hpp"
#include "experiment/process.hpp"
#include "experiment/rounds.hpp"

namespace amiss::experiment {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kNoSuchProgram = 127;
constexpr std::chrono::milliseconds kBetweenLooks(500);

void check_program(const ParallelOptions& options) {
  const Ended ended = run_program({options.command, "--version"}, "", [] { return false; });
  if (ended.status != 0 || ended.out.find("GNU parallel") == std::string::npos) {
    throw ArgumentError(options.command +
                        ": is no GNU parallel; --engine parallel needs it on the PATH (Debian's parallel)");
  }
}

/// GNU parallel quotes for the shell of its caller, and for none that other machines understand where it knows none.
constexpr const char* kShell = "PARALLEL_SHELL=/bin/sh";

/// One line of the input is one call; `uq()` makes its ids words of their own. What a machine at the other end of ssh
/// must know of our environment is handed on.
std::vector<std::string> words_of(const Folder& folder, const std::string& program, const ParallelOptions& options) {
  std::vector<std::string> words{"env", kShell, options.command, "--will-cite", fmt::format("--jobs={}", options.jobs),
                                 "--termseq=TERM,3000,KILL,25"};
  for (const std::string& login : options.logins) words.push_back("--sshlogin=" + login);
  for (const char* name : {"AMISS_SHARE", "XDG_CACHE_HOME"}) {
    if (std::getenv(name) != nullptr) words.push_back(fmt::format("--env={}", name));
  }
  words.insert(words.end(),
               {shell_quoted(program), "experiment", "work", shell_quoted(folder.path().string()), "{= uq() =}"});
  return words;
}

}  // namespace

bool run_in_parallel(const Folder& folder, const std::string& program, const ParallelOptions& options,
                     const RunHooks& hooks) {
  check_program(options);
  const auto words = words_of(folder, program, options);
  const std::size_t all = folder.missing().size();
  const auto round = [&](const std::vector<Trial>& missing) {
    std::string input;
    for (const Task& task : tasks_of(missing, options.chunk)) input += fmt::format("{}\n", fmt::join(task, " "));
    Clock::time_point looked_at;
    const Ended ended = run_program(words, input, [&] {
      if (Clock::now() - looked_at > kBetweenLooks) {
        hooks.progress(all - folder.missing().size(), all);
        looked_at = Clock::now();
      }
      return hooks.stop();
    });
    return RoundEnd{ended.stopped || hooks.stop(), last_line(ended.err)};
  };
  const bool done = run_rounds(folder, round, hooks);
  hooks.progress(all - folder.missing().size(), all);
  return done;
}

}  // namespace amiss::experiment
