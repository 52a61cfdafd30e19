#include "experiment/slurm.hpp"

#include <gtest/gtest.h>

#include "core/temporary_folder.hpp"

namespace amiss::experiment {
namespace {

struct Said {
  std::vector<std::vector<std::string>> calls;
  Ended ended;
  [[nodiscard]] Slurm slurm() {
    return Slurm([this](const std::vector<std::string>& words) {
      calls.push_back(words);
      return ended;
    });
  }
};

TEST(Slurm, ReadsHowLargeAnArrayMayBe) {
  EXPECT_EQ(parse_max_array_size("Configuration data as of now\nMaxArraySize            = 1001\nMaxJobCount = 5\n"),
            1001);
  EXPECT_THROW((void)parse_max_array_size("MaxJobCount = 5\n"), SlurmError);
  EXPECT_THROW((void)parse_max_array_size("MaxArraySize = many\n"), SlurmError);
}

TEST(Slurm, ReadsTheQueue) {
  const auto tasks = parse_queue(
      "amiss-x-1|7|3|PD|Resources\namiss-x-2|8|0|R|None\namiss-x-2|8|1|CG|\n"
      "amiss-x-2|8|2|PD|launch failed requeued held\namiss-x-2|8|3|PD|JobHeldUser\n");
  ASSERT_EQ(tasks.size(), 5U);
  EXPECT_EQ(tasks[0].job, "amiss-x-1");
  EXPECT_EQ(tasks[0].id, "7");
  EXPECT_EQ(tasks[0].task, 3);
  EXPECT_FALSE(tasks[0].runs);
  EXPECT_EQ(tasks[0].reason, "Resources");
  EXPECT_TRUE(tasks[1].runs);
  EXPECT_TRUE(tasks[2].runs) << "about to end";
  EXPECT_TRUE(tasks[3].given_up);
  for (const int i : {0, 1, 2, 4}) EXPECT_FALSE(tasks[static_cast<std::size_t>(i)].given_up) << i;
  EXPECT_TRUE(parse_queue("").empty());
  EXPECT_THROW((void)parse_queue("slurm says hello\n"), SlurmError);
  EXPECT_THROW((void)parse_queue("amiss-x-1|7|N/A|R|\n"), SlurmError);
}

TEST(Slurm, CallsItsCommands) {
  Said said;
  EXPECT_TRUE(said.slurm().queue({}).empty());
  EXPECT_TRUE(said.calls.empty()) << "no name would stand for all jobs";
  said.ended.out = "a|7|0|R|None\n";
  EXPECT_EQ(said.slurm().queue({"a", "b"}).size(), 1U);
  EXPECT_EQ(said.calls.back().back(), "--name=a,b");
  said.slurm().submit("1.sh");
  EXPECT_EQ(said.calls.back(), (std::vector<std::string>{"sbatch", "--parsable", "1.sh"}));
  said.slurm().cancel({"a", "b"});
  EXPECT_EQ(said.calls.back(), (std::vector<std::string>{"scancel", "--name=b"}));
  said.slurm().cancel_task(QueuedTask{"a", "7", 3, false, true, "held"});
  EXPECT_EQ(said.calls.back(), (std::vector<std::string>{"scancel", "7_3"}));
}

TEST(Slurm, TellsWhatWentWrong) {
  Said said;
  said.ended.status = 127;
  const auto sentence = [&] { return test::sentence_of<SlurmError>([&] { said.slurm().submit("1.sh"); }); };
  EXPECT_NE(sentence().find("sbatch: there is no such program; --engine slurm needs Slurm's commands"),
            std::string::npos);
  said.ended.status = 1;
  said.ended.err = "sbatch: error: invalid partition specified: x\nsbatch: error: Batch job submission failed: no\n";
  EXPECT_EQ(sentence(), "sbatch: error: Batch job submission failed: no");
}

}  // namespace
}  // namespace amiss::experiment
