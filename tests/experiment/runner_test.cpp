#include "experiment/runner.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

#include "core/random.hpp"
#include "core/temporary_folder.hpp"
#include "experiment/sample_report.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

/// A stand-in for amiss: writes a report into its --out after a moment.
struct Runner : testing::Test {
  test::TemporaryFolder folder;
  fs::path spec_file =
      folder.write("e.yaml", "name: test\nworlds: [lab_30]\nmethods: [dynamic, static]\nobjects: [2]\nruns: 6\n");
  std::vector<Trial> trials = trials_of(load_spec(spec_file), {{"lab_30", "key"}}, "program");
  Folder out = Folder::begin(folder.path() / "out", spec_file, trials);

  Runner() { folder.write("report.json", report::to_json(sample_report(), "")); }
  [[nodiscard]] std::string program(const std::string& script) const {
    const fs::path file = folder.write(
        "program",
        "#!/bin/sh\nfor w in \"$@\"; do case \"$w\" in --out=*) out=${w#--out=};; --seed=*) seed=${w#--seed=};; "
        "esac; done\nmkdir -p \"$out\"\necho half > \"$out\"/half\n" +
            script);
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }
  [[nodiscard]] std::string report() const { return "cp " + (folder.path() / "report.json").string() + " \"$out\"\n"; }
  [[nodiscard]] std::map<std::string, std::string> results_of(const Folder& from) const {
    std::map<std::string, std::string> results;
    for (const auto& entry : fs::directory_iterator(from.path() / "trials")) {
      if (entry.path().extension() != ".json") continue;  // half written when it was killed
      std::ostringstream bytes;
      bytes << std::ifstream(entry.path()).rdbuf();
      results[entry.path().filename()] = bytes.str();
    }
    return results;
  }
};

TEST_F(Runner, DoesWhatIsMissingAndLeavesNothingBehind) {
  std::size_t last = 0;
  RunHooks hooks;
  hooks.progress = [&](std::size_t done, std::size_t) { last = done; };
  EXPECT_TRUE(run_trials(out, out.missing(), 3, program(report()), hooks));
  EXPECT_EQ(last, 12U);
  EXPECT_EQ(out.results().size(), 12U);
  EXPECT_TRUE(fs::is_empty(out.path() / "work"));
  EXPECT_TRUE(run_trials(out, out.missing(), 3, "/nowhere", hooks)) << "nothing is missing";
}

TEST_F(Runner, NotAllFoundIsAResultAndAFailureIsKept) {
  EXPECT_TRUE(run_trials(out, {trials[0]}, 1, program(report() + "exit 1\n"), {}));
  EXPECT_FALSE(out.result(trials[0]).failed);
  EXPECT_TRUE(run_trials(out, {trials[1]}, 1, program("echo first >&2; echo 'no such world' >&2; exit 3\n"), {}));
  EXPECT_EQ(out.result(trials[1]).why, "status 3: no such world");
  EXPECT_TRUE(run_trials(out, {trials[2]}, 1, program("kill -11 $$\n"), {}));
  EXPECT_EQ(out.result(trials[2]).why, "ended by signal 11");
  EXPECT_TRUE(run_trials(out, {trials[3]}, 1, program("exit 0\n"), {}));
  EXPECT_TRUE(out.result(trials[3]).failed) << "no report";
}

TEST_F(Runner, AChildKilledFromOutsideIsStartedAgain) {
  const std::string once = (folder.path() / "once").string();
  EXPECT_TRUE(run_trials(out, {trials[0]}, 1,
                         program("if [ ! -e " + once + " ]; then touch " + once + "; kill -9 $$; fi\n" + report()),
                         {}));
  EXPECT_FALSE(out.result(trials[0]).failed);
}

TEST_F(Runner, StoppedTrialsLeaveNoResult) {
  RunHooks hooks;
  const auto begin = std::chrono::steady_clock::now();
  hooks.stop = [&] { return std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(100); };
  EXPECT_FALSE(run_trials(out, out.missing(), 2, program("exec sleep 60\n"), hooks));
  EXPECT_TRUE(out.results().empty());
  EXPECT_FALSE(run_trials(out, out.missing(), 2, program(report() + "exit 130\n"), {})) << "the child was interrupted";
  EXPECT_TRUE(out.results().empty());
}

TEST_F(Runner, TwoProcessesDoNoTrialTwice) {
  const std::string log = (folder.path() / "log").string();
  const std::string slow = program("echo $seed >>" + log + "\nsleep 0.05\n" + report());
  const pid_t child = ::fork();
  if (child == 0) ::_exit(run_trials(out, trials, 2, slow, {}) ? 0 : 1);
  EXPECT_TRUE(run_trials(out, trials, 2, slow, {}));
  int status = 1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  const std::string ran = folder.read("log");
  EXPECT_EQ(std::count(ran.begin(), ran.end(), '\n'), 12);
  EXPECT_TRUE(fs::is_empty(out.path() / "work"));
}

TEST_F(Runner, WorkThatIsClearedAwayIsNoFailure) {
  const std::string once = (folder.path() / "once").string();
  const std::string cleared =
      program("if [ ! -e " + once + " ]; then touch " + once + "; sleep 0.3; fi\n" + report() + "exit $?\n");
  const pid_t child = ::fork();
  if (child == 0) ::_exit(run_trial(out, trials[0], cleared, {}) ? 0 : 1);
  while (!fs::exists(once)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  out.clear_work();
  int status = 1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(out.result(trials[0]).failed);
}

TEST_F(Runner, KilledAtAnyTimeNothingIsLostOrDoubled) {
  const std::string slow = program("sleep 0.02\n" + report());
  const Folder whole = Folder::begin(folder.path() / "whole", spec_file, trials);
  ASSERT_TRUE(run_trials(whole, trials, 3, slow, {}));
  RandomStream random(5, "kill");
  int killed = 0;
  for (int attempt = 0; attempt < 30; ++attempt) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(run_trials(out, out.missing(), 3, slow, {}) ? 0 : 1);
    std::this_thread::sleep_for(std::chrono::microseconds(random.below(60000)));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) ++killed;
    for (const auto& [name, bytes] : results_of(out)) EXPECT_EQ(bytes, results_of(whole).at(name));
  }
  EXPECT_GT(killed, 3);
  out.clear_work();
  ASSERT_TRUE(run_trials(out, out.missing(), 3, slow, {}));
  std::erase_if(trials, [&](const Trial& t) { return out.has(t); });
  EXPECT_TRUE(trials.empty());
  EXPECT_EQ(results_of(out), results_of(whole));
  for (const auto& entry : fs::directory_iterator(out.path() / "trials")) {
    EXPECT_EQ(entry.path().extension(), ".json") << "half written files are cleared away";
  }
}

}  // namespace
}  // namespace amiss::experiment
