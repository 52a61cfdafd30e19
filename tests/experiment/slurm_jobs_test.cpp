#include "experiment/slurm_jobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "experiment/stand_in/experiment.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

/// Slurm as one remembers it: takes scripts until it is told to refuse.
struct SlurmJobsTest : StandInExperiment {
  Folder out = begin("out");
  std::vector<std::string> submitted;
  int accepts = 100;
  std::string queue;  // what squeue prints

  Ended call(const std::vector<std::string>& words) {
    Ended ended;
    if (words[0] == "scontrol") ended.out = "MaxArraySize = 2\n";
    if (words[0] == "squeue") ended.out = queue;
    if (words[0] == "sbatch" && accepts-- <= 0) return {1, 0, false, "", "sbatch: error: too many jobs\n"};
    if (words[0] == "sbatch") submitted.push_back(words.back());
    if (words[0] == "scancel") queue.clear();
    return ended;
  }
  SlurmJobs jobs(int chunk = 2) {
    SlurmOptions options;
    options.chunk = chunk;
    return {out, program, options, [this](const std::vector<std::string>& words) { return call(words); }};
  }
  [[nodiscard]] static std::string line(const std::string& name, int task) {
    return name + "|7|" + std::to_string(task) + "|R|None\n";
  }
};

TEST_F(SlurmJobsTest, AsManyArraysAsTheirSizeAsksFor) {
  SlurmOptions options;
  options.chunk = 5;
  const auto scripts = slurm_scripts(out, out.trials(), program, options, 2, 4);
  ASSERT_EQ(scripts.size(), 2U);
  EXPECT_EQ(parse_tasks(scripts[0], "").size(), 2U);
  EXPECT_EQ(parse_tasks(scripts[1], "").size(), 1U);
  std::vector<std::string> ids;
  for (const std::string& script : scripts) {
    for (const Task& task : parse_tasks(script, "")) ids.insert(ids.end(), task.begin(), task.end());
  }
  ASSERT_EQ(ids.size(), 12U);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(ids[i], out.trials()[i].id);
  EXPECT_NE(scripts[0].find("-4\n"), std::string::npos) << "the number is part of the job's name";
  EXPECT_EQ(slurm_scripts(out, out.trials(), program, options, 1001).size(), 1U);
}

TEST_F(SlurmJobsTest, FindsItsJobsAgain) {
  SlurmJobs first = jobs();
  EXPECT_TRUE(first.names().empty());
  EXPECT_EQ(first.submit(out.trials()), "");
  EXPECT_EQ(submitted.size(), 3U);
  EXPECT_EQ(first.names().size(), 3U);
  SlurmJobs second = jobs();
  EXPECT_EQ(second.names(), first.names());
  queue = line(first.names()[0], 1) + line(first.names()[2], 0);
  const auto others = second.without(out.trials(), second.queue());
  std::set<std::string> ids;
  for (const Trial& trial : others) ids.insert(trial.id);
  EXPECT_EQ(ids.size(), 8U);
  for (const int i : {2, 3, 8, 9}) EXPECT_FALSE(ids.contains(out.trials()[static_cast<std::size_t>(i)].id));
  EXPECT_EQ(second.submit({out.trials()[0]}), "");
  EXPECT_EQ(second.names().size(), 4U) << "a number of its own";
}

TEST_F(SlurmJobsTest, WhatSlurmGaveUpIsEndedAndLost) {
  SlurmJobs some = jobs();
  (void)some.submit(out.trials());
  queue = some.names()[0] + "|7|1|PD|launch failed requeued held\n";
  EXPECT_TRUE(some.queue().empty());
  EXPECT_EQ(queue, "") << "ended";
}

TEST_F(SlurmJobsTest, AnotherFolderHasOtherNames) {
  SlurmJobs one = jobs();
  (void)one.submit(out.trials());
  const Folder elsewhere = begin("elsewhere");
  SlurmJobs other(elsewhere, program, {}, [this](const std::vector<std::string>& words) { return call(words); });
  (void)other.submit(elsewhere.trials());
  EXPECT_NE(one.names().front(), other.names().front());
}

TEST_F(SlurmJobsTest, RefusedAtOnceOrLater) {
  accepts = 0;
  SlurmJobs refused = jobs();
  EXPECT_EQ(test::sentence_of<SlurmError>([&] { (void)refused.submit(out.trials()); }), "sbatch: error: too many jobs");
  accepts = 2;
  EXPECT_EQ(refused.submit(out.trials()), "sbatch: error: too many jobs");
  EXPECT_EQ(submitted.size(), 2U);
}

TEST_F(SlurmJobsTest, TellsTheEndOfALog) {
  SlurmJobs some = jobs();
  EXPECT_EQ(some.last_words(out.trials()[7]), "");
  (void)some.submit(out.trials());
  EXPECT_EQ(some.last_words(out.trials()[7]), "") << "the task did not begin";
  out.save("slurm/2_1.log", "something\nno such library\n");
  EXPECT_EQ(some.last_words(out.trials()[7]), "no such library");
}

TEST_F(SlurmJobsTest, ForgetsWhatIsDone) {
  SlurmJobs some = jobs();
  (void)some.submit(out.trials());
  queue = line(some.names()[0], 1);
  some.forget();
  EXPECT_EQ(queue, "") << "ended";
  EXPECT_FALSE(fs::exists(out.path() / "slurm"));
}

}  // namespace
}  // namespace amiss::experiment
