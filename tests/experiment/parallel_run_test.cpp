#include "experiment/parallel_run.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "core/result.hpp"
#include "experiment/process.hpp"
#include "experiment/stand_in/experiment.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

/// A stand-in for ssh: notes the machine and runs the command here.
struct ParallelRun : StandInExperiment {
  Variable home{"PARALLEL_HOME", folder.path() / "home"};
  ParallelRun() { fs::create_directories(folder.path() / "home"); }
  void SetUp() override {
    if (run_program({"parallel", "--version"}, "", [] { return false; }).status != 0) {
      GTEST_SKIP() << "GNU parallel is not here; `apt-get install parallel` brings it";
    }
  }
  [[nodiscard]] std::string script(const std::string& name, const std::string& text) const {
    const fs::path file = folder.write(name, "#!/bin/sh\n" + text);
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }
};

TEST_F(ParallelRun, GivesTheSameAsARunHere) {
  const auto expected = expected_files();
  const Folder out = begin("it's a place");
  std::size_t last = 0;
  RunHooks watching = hooks();
  watching.progress = [&](std::size_t done, std::size_t) { last = done; };
  EXPECT_TRUE(run_in_parallel(out, program, {"parallel", 5, 2, {}}, watching)) << all_told();
  EXPECT_EQ(files_of(out), expected);
  EXPECT_EQ(last, 12U);
  EXPECT_EQ(all_told(), "");
  for (const auto& [id, times] : ran(out)) EXPECT_EQ(times, 1) << id;
}

TEST_F(ParallelRun, OnOtherMachines) {
  const auto expected = expected_files();
  const std::string ssh =
      script("ssh", "echo \"$1\" >>" + (folder.path() / "machines").string() + "\nshift 2\nexec sh -c \"$*\"\n");
  const Folder out = begin("out");
  const ParallelOptions options{"parallel", 1, 2, {"2/" + ssh + " one", "2/" + ssh + " two"}};
  EXPECT_TRUE(run_in_parallel(out, program, options, hooks())) << all_told();
  EXPECT_EQ(files_of(out), expected);
  const std::string machines = folder.read("machines");
  EXPECT_NE(machines.find("one"), std::string::npos);
  EXPECT_NE(machines.find("two"), std::string::npos);
}

TEST_F(ParallelRun, WhatIsLostIsHandedOutAgain) {
  const auto expected = expected_files();
  const std::string lost = (folder.path() / "lost").string();
  const std::string flaky =
      script("flaky", "if mkdir " + lost + " 2>/dev/null; then echo 'a disk is full' >&2; exit 3; fi\nexec " + program +
                          " \"$@\"\n");
  const Folder out = begin("out");
  EXPECT_TRUE(run_in_parallel(out, flaky, {"parallel", 4, 2, {}}, hooks()));
  EXPECT_EQ(files_of(out), expected);
  EXPECT_EQ(all_told(),
            "4 trials came back without a result and are handed out again, the last words are: a disk is full\n");
}

TEST_F(ParallelRun, TellsWhenNothingComesOfIt) {
  const Folder out = begin("out");
  EXPECT_FALSE(run_in_parallel(out, script("bad", "echo 'no such library' >&2; exit 127\n"), {}, hooks()));
  EXPECT_NE(all_told().find("nothing came of handing them out 3 times, the last words are: no such library"),
            std::string::npos)
      << all_told();
  EXPECT_NE(test::sentence_of<ArgumentError>([&] {
              (void)run_in_parallel(out, program, {"/nowhere/parallel", 1, 1, {}}, hooks());
            }).find("is no GNU parallel; --engine parallel needs it"),
            std::string::npos);
}

TEST_F(ParallelRun, StopsWhenAsked) {
  const Folder out = begin("out", 30.0);
  RunHooks stopping = hooks();
  stopping.stop = [&] { return !ran(out).empty(); };
  EXPECT_FALSE(run_in_parallel(out, program, {}, stopping));
  EXPECT_EQ(out.missing().size(), 12U);
}

/// Those that do a trial go on when the run is killed, and the next run does not do it a second time.
TEST_F(ParallelRun, KilledNothingIsLostOrDoubled) {
  const auto expected = expected_files();
  const Folder out = begin("out", 0.3);
  for (int kills = 0; kills < 2; ++kills) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(run_in_parallel(out, program, {"parallel", 2, 2, {}}, {}) ? 0 : 1);
    while (std::ssize(ran(out)) < 3 * (kills + 1)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  EXPECT_TRUE(run_in_parallel(out, program, {"parallel", 2, 2, {}}, hooks())) << all_told();
  const auto times = ran(out);
  EXPECT_EQ(times.size(), 12U);
  for (const auto& [id, count] : times) EXPECT_EQ(count, 1) << id;
  auto results = files_of(out);
  results["experiment.yaml"] = expected.at("experiment.yaml");  // the moment a trial takes differs
  EXPECT_EQ(results, expected);
}

}  // namespace
}  // namespace amiss::experiment
