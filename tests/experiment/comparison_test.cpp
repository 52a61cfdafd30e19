#include "experiment/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/result.hpp"
#include "experiment/sample_results.hpp"

namespace amiss::experiment {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(Measured, TimesAreRecomputedAsTheThesisDoes) {
  const TrialResult fast = sample_result("dynamic", 1, {20.0, 50.0}, 2, 1.0);
  EXPECT_DOUBLE_EQ(measured(fast, "segmentations"), 2.0);
  EXPECT_DOUBLE_EQ(measured(fast, "time_simulation_s"), 50.0) << "as it was run";
  EXPECT_DOUBLE_EQ(measured(fast, "time_real_robot_s"), 50.0 - 2.0 + 2.0 * 5.0);
  EXPECT_DOUBLE_EQ(measured(fast, "time_fast_s"), 48.04);
  const TrialResult slow = sample_result("static", 1, {20.0, 50.0}, 2, 6.0);
  EXPECT_DOUBLE_EQ(measured(slow, "time_real_robot_s"), 50.0 - 12.0 + 18.0);
  EXPECT_EQ(found_at_s(slow, report::kSegmentationTimes[2]), (std::vector<double>{14.04, 38.08}));
  EXPECT_THROW((void)measured(fast, "time"), ArgumentError);
}

TEST(Measured, WhatFoundNotAllIsLongerThanAll) {
  for (const std::string& measure : measures()) {
    EXPECT_EQ(measured(sample_result("static", 1, {20.0}, 2, 6.0), measure), kInfinite);
    EXPECT_EQ(measured(sample_failure("static", 1, 2), measure), kInfinite);
  }
}

TEST(Comparison, IsPairedBySeed) {
  std::vector<TrialResult> results;
  for (const std::uint64_t seed : {3U, 1U, 2U}) {
    results.push_back(sample_result("static", seed, {10.0 * static_cast<double>(seed)}, 1, 6.0));
  }
  for (const std::uint64_t seed : {1U, 2U, 4U}) {
    results.push_back(sample_result("dynamic", seed, {4.0 + static_cast<double>(seed)}, 1, 1.0));
  }
  const Cell cell = cell_of(results, "lab_30", 1, "time_simulation_s");
  const auto c = compared(cell);
  ASSERT_TRUE(c.has_value());
  EXPECT_EQ(c->difference.n, 2) << "seeds 1 and 2";
  EXPECT_DOUBLE_EQ(c->difference.quartiles.median, (5.0 + 14.0) / 2.0);
  EXPECT_DOUBLE_EQ(c->test.effect, 1.0);
  EXPECT_DOUBLE_EQ(c->test.p, 0.5);
  EXPECT_DOUBLE_EQ(c->ratio_of_medians, 15.0 / 5.5);
  EXPECT_DOUBLE_EQ(c->ratio_of_means, 30.0 / 11.0);
  EXPECT_FALSE(compared(cell_of(results, "flat_90", 1, "segmentations")).has_value());
}

TEST(Comparison, FailuresOfBothAreATieAndOfOneALoss) {
  const std::vector<TrialResult> results{sample_failure("static", 1, 1), sample_failure("dynamic", 1, 1),
                                         sample_result("static", 2, {}, 1, 6.0),
                                         sample_result("dynamic", 2, {9.0}, 1, 1.0)};
  const auto c = compared(cell_of(results, "lab_30", 1, "segmentations"));
  ASSERT_TRUE(c.has_value());
  EXPECT_EQ(c->test.zeros, 1);
  EXPECT_EQ(c->test.n, 1);
  EXPECT_EQ(c->difference.quartiles.q3, kInfinite);
  EXPECT_TRUE(std::isnan(c->ratio_of_medians));
}

TEST(Cells, AreAllBatchesAndMeasures) {
  Spec spec;
  spec.worlds = {"lab_30", "flat_90"};
  spec.objects = {1, 3};
  const auto cells = cells_of(spec, {sample_result("dynamic", 1, {1.0}, 1, 1.0)});
  ASSERT_EQ(cells.size(), 2U * 2U * measures().size());
  EXPECT_NE(cells.front().sample("dynamic"), nullptr);
  EXPECT_EQ(cells.front().sample("static"), nullptr);
  EXPECT_EQ(cells.back().sample("dynamic"), nullptr);
  const Described once = described(cells[0], *cells[0].sample("dynamic"));
  EXPECT_EQ(once.n, 1);
  EXPECT_DOUBLE_EQ(once.median_95.low, 1.0);
}

}  // namespace
}  // namespace amiss::experiment
