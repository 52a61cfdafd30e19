#include "experiment/rounds.hpp"

#include <gtest/gtest.h>

#include "experiment/stand_in/experiment.hpp"

namespace amiss::experiment {
namespace {

struct Rounds : StandInExperiment {
  Folder out = begin("out");
  std::vector<std::size_t> handed;

  /// Each round gives `results` results.
  bool run(const std::vector<std::size_t>& results) {
    return run_rounds(
        out,
        [&](const std::vector<Trial>& missing) {
          const std::size_t n = handed.size() < results.size() ? results[handed.size()] : 0;
          for (std::size_t i = 0; i < n; ++i) out.save_result(missing[i], "{}", "");
          handed.push_back(missing.size());
          return RoundEnd{false, "a node is down"};
        },
        hooks());
  }
};

TEST_F(Rounds, GoOnUntilNothingIsMissing) {
  out.save("work/rest/file", "left by a killed run");
  EXPECT_TRUE(run({4, 0, 0, 3, 0, 5}));
  EXPECT_EQ(handed, (std::vector<std::size_t>{12, 8, 8, 8, 5, 5}));
  EXPECT_EQ(told.size(), 5U);
  EXPECT_EQ(told.front(),
            "8 trials came back without a result and are handed out again, the last words are: a node is down");
  EXPECT_TRUE(std::filesystem::is_empty(out.path() / "work"));
}

TEST_F(Rounds, EndWhenNothingComesOfIt) {
  EXPECT_FALSE(run({2}));
  EXPECT_EQ(handed.size(), 4U);
  EXPECT_EQ(told.back(),
            "10 trials are missing and nothing came of handing them out 3 times, the last words are: a node is down");
}

TEST_F(Rounds, EndWhenStopped) {
  EXPECT_FALSE(run_rounds(
      out,
      [](const std::vector<Trial>&) {
        return RoundEnd{true, ""};
      },
      hooks()));
  EXPECT_TRUE(told.empty());
}

TEST_F(Rounds, NothingMissingNeedsNoRound) {
  for (const Trial& trial : out.trials()) out.save_result(trial, "{}", "");
  EXPECT_TRUE(run({}));
  EXPECT_TRUE(handed.empty());
}

}  // namespace
}  // namespace amiss::experiment
