#include "score/novel_score.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace amiss::score {
namespace {

TEST(NovelScore, CountsPointsObjectsAndClusters) {
  // Object 0 is found with two of three points and two points too many, object 1 is not; cluster 1 touches nothing.
  const NovelScore score = score_novel({{1, 2, 10, 11}, {20, 21}}, {{1, 2, 3}, {30, 31}});
  EXPECT_DOUBLE_EQ(score.precision, 2.0 / 6.0);
  EXPECT_DOUBLE_EQ(score.recall, 2.0 / 5.0);
  EXPECT_DOUBLE_EQ(score.f1, 2.0 * (1.0 / 3.0) * 0.4 / (1.0 / 3.0 + 0.4));
  EXPECT_EQ(score.missed, (std::vector<std::size_t>{1}));
  EXPECT_EQ(score.wrong, (std::vector<std::size_t>{1}));
}

TEST(NovelScore, OnePointIsEnoughForAnObjectAndForACluster) {
  const NovelScore score = score_novel({{5, 6, 7, 8}}, {{8, 9, 10, 11}});
  EXPECT_TRUE(score.missed.empty());
  EXPECT_TRUE(score.wrong.empty());
}

TEST(NovelScore, APointThatStandsTwiceCountsOnce) {
  const NovelScore score = score_novel({{1, 1, 2}, {2, 3}}, {{1, 2}, {2, 2}});
  EXPECT_EQ(score.found_points, 3U);
  EXPECT_EQ(score.annotated_points, 2U);
  EXPECT_EQ(score.true_points, 2U);
}

TEST(NovelScore, NothingFoundAndNothingToFindAreDefined) {
  EXPECT_EQ(score_novel({}, {}).f1, 1.0);
  EXPECT_EQ(score_novel({}, {{1}}).precision, 0.0);
  EXPECT_EQ(score_novel({}, {{1}}).f1, 0.0);
  EXPECT_EQ(score_novel({{1}}, {}).precision, 0.0);
  EXPECT_EQ(score_novel({{1}}, {}).recall, 1.0);
  EXPECT_EQ(score_novel({}, {{}}).missed.size(), 1U) << "an object without points cannot be found";
}

RC_GTEST_PROP(NovelScore, IsWhatCountingOverSetsGives, ()) {
  const auto sets =
      rc::gen::container<std::vector<PointSet>>(rc::gen::container<PointSet>(rc::gen::inRange<std::uint32_t>(0, 30)));
  const std::vector<PointSet> found = *sets, objects = *sets;
  std::set<std::uint32_t> a, b, both;
  for (const PointSet& s : found) a.insert(s.begin(), s.end());
  for (const PointSet& s : objects) b.insert(s.begin(), s.end());
  for (const std::uint32_t i : a) {
    if (b.contains(i)) both.insert(i);
  }
  const NovelScore score = score_novel(found, objects);
  RC_ASSERT(score.true_points == both.size());
  if (!a.empty()) RC_ASSERT(score.precision == static_cast<double>(both.size()) / static_cast<double>(a.size()));
  if (!b.empty()) RC_ASSERT(score.recall == static_cast<double>(both.size()) / static_cast<double>(b.size()));
  std::size_t missed = 0;
  for (const PointSet& s : objects) {
    missed += std::none_of(s.begin(), s.end(), [&](std::uint32_t i) { return a.contains(i); }) ? 1U : 0U;
  }
  RC_ASSERT(score.missed.size() == missed);
}

TEST(Table52, RowsAreMeansOfVisitsAndTheAverageIsThatOfRooms) {
  const std::vector<NovelTrial> trials = {{"big_room", "full", 0.4, 0.8, 0.5, 1, 3},
                                          {"big_room", "full", 0.8, 0.8, 0.7, 2, 5},
                                          {"kitchen", "full", 1.0, 0.2, 0.3, 0, 1}};
  const std::vector<NovelRow> rows = table52(trials);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].room, "big_room");
  EXPECT_NEAR(rows[0].precision.mean, 0.6, 1e-12);
  EXPECT_NEAR(rows[0].precision.deviation, 0.2, 1e-12);
  EXPECT_NEAR(rows[0].recall.deviation, 0.0, 1e-12);
  EXPECT_EQ(rows[0].missed, 3.0);
  EXPECT_EQ(rows[0].wrong, 8.0);
  EXPECT_EQ(rows[2].room, "average");
  EXPECT_NEAR(rows[2].precision.mean, 0.8, 1e-12);                         // of 0.6 and 1.0: rooms count alike
  EXPECT_NEAR(rows[2].precision.deviation, std::sqrt(0.56 / 9.0), 1e-12);  // of 0.4, 0.8, 1.0
  EXPECT_EQ(rows[2].missed, 1.5);
  EXPECT_EQ(rows[2].wrong, 4.5);
}

TEST(Table52, MethodsKeepTheirOrderInEveryRoom) {
  const std::vector<NovelRow> rows = table52(
      {{"b", "y", 0, 0, 0, 0, 0}, {"b", "x", 0, 0, 0, 0, 0}, {"a", "x", 0, 0, 0, 0, 0}, {"a", "y", 0, 0, 0, 0, 0}});
  ASSERT_EQ(rows.size(), 6U);
  const std::vector<std::string> expected = {"b y", "b x", "a y", "a x", "average y", "average x"};
  for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(rows[k].room + " " + rows[k].method, expected[k]);
}

}  // namespace
}  // namespace amiss::score
