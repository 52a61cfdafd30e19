#include "experiment/slurm_run.hpp"

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <thread>

#include "experiment/process.hpp"
#include "experiment/stand_in/experiment.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const auto kGoOn = [] { return false; };

SlurmOptions quick(int chunk) {
  SlurmOptions options;
  options.chunk = chunk;
  options.poll = 300ms;
  return options;
}

/// Slurm's commands as scripts: sbatch does the tasks of an array on the spot.
struct SlurmStandIn : StandInExperiment {
  fs::path bin = folder.path() / "bin";
  Variable path{"PATH", bin.string() + ":" + ::getenv("PATH")};
  Folder out = begin("out");

  void command(const std::string& name, const std::string& text) const {
    fs::create_directories(bin);
    std::ofstream(bin / name) << "#!/bin/sh\nstate=" + folder.path().string() + "\n" + text;
    fs::permissions(bin / name, fs::perms::owner_all);
  }
  SlurmStandIn() {
    command("scontrol", "echo 'MaxArraySize = 4'\n");
    command("squeue", "[ ! -e $state/queue ] || cat $state/queue\n");
    command("scancel", "rm -f $state/queue\n");
    accept();
  }
  void accept(const std::string& first = "") const {
    command("sbatch", first +
                          "echo \"$2\" >>$state/submitted\n"
                          "last=$(sed -n 's/^#SBATCH --array=0-//p' \"$2\")\n"
                          "for i in $(seq 0 $last); do SLURM_ARRAY_TASK_ID=$i sh \"$2\"; done\necho 1\n");
  }
};

TEST_F(SlurmStandIn, GivesTheSameAsARunHere) {
  const auto expected = expected_files();
  EXPECT_TRUE(run_on_slurm(out, program, quick(2), hooks()));
  EXPECT_EQ(files_of(out), expected);
  EXPECT_EQ(all_told(), "");
  const std::string submitted = folder.read("submitted");
  EXPECT_EQ(std::count(submitted.begin(), submitted.end(), '\n'), 2) << "MaxArraySize";
  EXPECT_TRUE(run_on_slurm(out, program, quick(2), hooks())) << "nothing is missing";
}

TEST_F(SlurmStandIn, WhatIsLostIsHandedOverAgainAndThenTold) {
  accept("[ -e $state/once ] || { touch $state/once; echo 1; exit; }\n");
  EXPECT_TRUE(run_on_slurm(out, program, quick(5), hooks()));
  EXPECT_NE(all_told().find("12 trials came back without a result and are handed out again"), std::string::npos);
  const Folder other = begin("other");
  EXPECT_FALSE(run_on_slurm(other, "/nowhere/amiss", quick(5), hooks()));
  EXPECT_NE(all_told().find("nothing came of handing them out 3 times, the last words are: "), std::string::npos);
  EXPECT_NE(all_told().find("/nowhere/amiss"), std::string::npos) << all_told();
}

TEST_F(SlurmStandIn, RefusalsAreTold) {
  command("sbatch", "echo 'sbatch: error: invalid partition specified: x' >&2; exit 1\n");
  EXPECT_EQ(test::sentence_of<SlurmError>([&] { (void)run_on_slurm(out, program, quick(2), hooks()); }),
            "sbatch: error: invalid partition specified: x");
  command("scontrol", "exit 127\n");
  EXPECT_NE(test::sentence_of<SlurmError>([&] {
              (void)run_on_slurm(out, program, quick(2), hooks());
            }).find("scontrol: there is no such program"),
            std::string::npos);
}

TEST_F(SlurmStandIn, SlurmThatDoesNotAnswerIsWaitedFor) {
  command("squeue",
          "n=$(cat $state/asked 2>/dev/null || echo 0); echo $((n + 1)) >$state/asked\n"
          "[ $n -gt 3 ] || { echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1; }\n");
  accept("[ -e $state/once ] || { touch $state/once; echo 1; exit; }\n");  // the first is lost
  EXPECT_TRUE(run_on_slurm(out, program, quick(2), hooks()));
  EXPECT_NE(all_told().find("squeue: slurm_load_jobs error: Unable to contact slurm controller; waiting for Slurm"),
            std::string::npos)
      << all_told();
}

TEST_F(SlurmStandIn, WhatSlurmGaveUpIsHandedOverAgain) {
  accept(
      "if [ ! -e $state/once ]; then touch $state/once; name=$(sed -n 's/^#SBATCH --job-name=//p' \"$2\")\n"
      "echo \"$name|7|0|PD|launch failed requeued held\" >$state/queue; echo 7; exit; fi\n");
  EXPECT_TRUE(run_on_slurm(out, program, quick(12), hooks())) << all_told();
  EXPECT_FALSE(fs::exists(folder.path() / "queue"));
}

TEST_F(SlurmStandIn, StoppedLeavesItsJobsAndSaysSo) {
  accept("touch $state/once; echo 1; exit\n");
  RunHooks stopping = hooks();
  stopping.stop = [&] { return fs::exists(folder.path() / "once"); };
  EXPECT_FALSE(run_on_slurm(out, program, quick(2), stopping));
  EXPECT_NE(all_told().find("the same call takes it up again, `scancel --name=amiss-"), std::string::npos);
  EXPECT_TRUE(fs::exists(out.path() / "slurm" / "1.sh"));
}

/// A real cluster of two nodes on loopback.
struct SlurmCluster : StandInExperiment {
  static constexpr auto kLimit = 120s;
  static inline std::unique_ptr<test::TemporaryFolder> place;
  static inline std::unique_ptr<Variable> configuration;

  static Ended cluster(const std::string& action, const std::string& what = "") {
    return run_program({AMISS_SOURCE_DIR "/tests/experiment/private_slurm.sh", action, place->path().string(), what},
                       "", kGoOn);
  }
  static bool installed() {
    const std::string script = "PATH=$PATH:/usr/sbin; for p in slurmctld slurmd munged sbatch; do command -v $p; done";
    const std::string found = run_program({"sh", "-c", script}, "", kGoOn).out;
    return std::count(found.begin(), found.end(), '\n') == 4;
  }
  /// Where slurmd reads which processors there are; a bare chroot has none, and no node comes up there.
  static bool has_processors() { return std::filesystem::exists("/sys/devices/system/cpu/cpu0/topology"); }
  static void SetUpTestSuite() {
    if (!installed() || !has_processors()) return;
    place = std::make_unique<test::TemporaryFolder>();
    const Ended started = cluster("start");
    ASSERT_EQ(started.status, 0) << started.err;
    configuration = std::make_unique<Variable>("SLURM_CONF", (place->path() / "slurm.conf").string());
  }
  static void TearDownTestSuite() {
    if (place) (void)cluster("stop");
    configuration.reset();
    place.reset();
  }
  void SetUp() override {
    if (!has_processors()) GTEST_SKIP() << "/sys tells of no processors: slurmd cannot work here";
    if (!place) {
      GTEST_SKIP() << "Slurm is not here; `apt-get install --no-install-recommends slurm-wlm munge` brings it";
    }
  }
  /// A run that hangs is a failure, not a test that never ends.
  RunHooks limited() {
    RunHooks limited = hooks();
    limited.stop = [until = std::chrono::steady_clock::now() + kLimit] {
      return std::chrono::steady_clock::now() > until;
    };
    return limited;
  }
  static void wait_for(const Folder& out, std::size_t results) {
    const auto until = std::chrono::steady_clock::now() + kLimit;
    while (out.trials().size() - out.missing().size() < results && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(50ms);
    }
  }
};

TEST_F(SlurmCluster, KilledDaemonsLoseNothing) {
  auto expected = expected_files();
  const Folder out = begin("out", 0.4);
  auto run = std::async(std::launch::async, [&] { return run_on_slurm(out, program, quick(1), limited()); });
  wait_for(out, 2);
  for (const char* daemon : {"sim1", "slurmctld"}) EXPECT_EQ(cluster("kill", daemon).status, 0);
  std::this_thread::sleep_for(1s);
  for (const char* daemon : {"slurmctld", "sim1"}) EXPECT_EQ(cluster("resume", daemon).status, 0);
  EXPECT_TRUE(run.get()) << all_told();
  expected["experiment.yaml"] = files_of(out).at("experiment.yaml");  // the moment a trial takes differs
  EXPECT_EQ(files_of(out), expected);
}

TEST_F(SlurmCluster, AKilledRunFindsItsJobsAgain) {
  const Folder out = begin("out", 0.3);
  const pid_t child = ::fork();
  if (child == 0) ::_exit(run_on_slurm(out, program, quick(3), {}) ? 0 : 1);
  wait_for(out, 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(run_on_slurm(out, program, quick(3), limited())) << all_told();
  const auto times = ran(out);
  EXPECT_EQ(times.size(), 12U);
  for (const auto& [id, count] : times) EXPECT_EQ(count, 1) << id;
  EXPECT_FALSE(fs::exists(out.path() / "slurm"));
}

TEST_F(SlurmCluster, CancelledTasksAreHandedOverAgain) {
  const Folder out = begin("out", 0.2);
  auto run = std::async(std::launch::async, [&] { return run_on_slurm(out, program, quick(3), limited()); });
  wait_for(out, 1);
  const std::string user = std::to_string(::getuid());
  EXPECT_EQ(run_program({"scancel", "--user=" + user}, "", kGoOn).status, 0);
  EXPECT_TRUE(run.get()) << all_told();
  EXPECT_NE(all_told().find("came back without a result"), std::string::npos);
  EXPECT_TRUE(out.missing().empty());
}

TEST_F(SlurmCluster, SaysWhatSlurmRefuses) {
  const Folder out = begin("out");
  SlurmOptions options = quick(3);
  options.sbatch = {"--partition=none"};
  EXPECT_NE(test::sentence_of<SlurmError>([&] {
              (void)run_on_slurm(out, program, options, limited());
            }).find("sbatch: error: Batch job submission failed: Invalid partition name specified"),
            std::string::npos);
}

}  // namespace
}  // namespace amiss::experiment
