#include "score/referee.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace amiss::score {
namespace {

constexpr std::uint16_t kMug = 7, kBall = 9;

world::ObjectTruth object(const std::string& name, std::uint16_t instance, const Eigen::Vector3d& centre) {
  world::ObjectTruth truth;
  truth.name = name;
  truth.kind = name;
  truth.instance = instance;
  truth.bounds = {centre - Eigen::Vector3d::Constant(0.05), centre + Eigen::Vector3d::Constant(0.05)};
  return truth;
}

/// A frame of 100 pixels in which 0 .. 39 show the mug and 40 .. 59 the ball; the map lies 10 m along x of the world.
struct RefereeOf : testing::Test {
  std::vector<world::ObjectTruth> objects{object("mug", kMug, {11.0, 2.0, 0.05}),
                                          object("ball", kBall, {13.0, 2.0, 0.05})};
  world::InstanceImage image{Stamp{}, 10, 10, std::vector<std::uint16_t>(100, 0)};
  Transform<World, Map> T_world_map;
  RefereeOf() {
    std::fill_n(image.instances.begin(), 40, kMug);
    std::fill_n(image.instances.begin() + 40, 20, kBall);
    T_world_map.T.translation() = Eigen::Vector3d(10.0, 0.0, 0.0);
  }
  [[nodiscard]] Referee referee() const { return {objects, T_world_map, RefereeParams()}; }
};

std::vector<std::uint32_t> pixels(std::uint32_t from, std::uint32_t to) {
  std::vector<std::uint32_t> list(to - from);
  std::iota(list.begin(), list.end(), from);
  return list;
}

const Stamp kNow{duration_of(12.5)};
const Point<Map> kAtMug{{1.03, 2.0, 0.05}};  // 0.03 m beside it

TEST_F(RefereeOf, CoveredNearIsFoundOnce) {
  Referee referee = this->referee();
  const auto mask = pixels(0, 38);
  const std::vector<JudgedSegment> segments{{mask, kAtMug}};
  EXPECT_EQ(referee.judge(kNow, segments, image, objects), std::vector<std::string>{"mug"});
  EXPECT_TRUE(referee.judge(kNow, segments, image, objects).empty()) << "no news";
  const ObjectVerdict& verdict = referee.verdicts().front();
  EXPECT_TRUE(verdict.found);
  EXPECT_DOUBLE_EQ(verdict.found_at_s, 12.5);
  EXPECT_NEAR(verdict.error_m, 0.03, 1e-12);
  EXPECT_DOUBLE_EQ(verdict.cover, 38.0 / 40.0);
  EXPECT_DOUBLE_EQ(verdict.purity, 1.0);
  EXPECT_EQ(verdict.found_position.p, kAtMug.p);
  EXPECT_EQ(referee.found(), 1);
  EXPECT_FALSE(referee.all_found());
}

TEST_F(RefereeOf, CoveredButFarIsNotFound) {
  Referee referee = this->referee();
  const auto mask = pixels(0, 40);
  const std::vector<JudgedSegment> segments{{mask, {{1.2, 2.0, 0.05}}}};
  EXPECT_TRUE(referee.judge(kNow, segments, image, objects).empty());
  EXPECT_TRUE(referee.verdicts().front().covered);
  EXPECT_FALSE(referee.verdicts().front().found);
  EXPECT_NEAR(referee.verdicts().front().error_m, 0.2, 1e-12);
}

TEST_F(RefereeOf, ASmallPartOfItIsNotEnough) {
  Referee referee = this->referee();
  const auto mask = pixels(0, 19);  // 19 of 40
  const std::vector<JudgedSegment> segments{{mask, kAtMug}};
  EXPECT_TRUE(referee.judge(kNow, segments, image, objects).empty());
  EXPECT_FALSE(referee.verdicts().front().covered);
}

TEST_F(RefereeOf, ASegmentOfMuchElseIsNotEnough) {
  Referee referee = this->referee();
  const auto mask = pixels(0, 100);  // 40 of 100 pixels show the mug
  const std::vector<JudgedSegment> segments{{mask, kAtMug}};
  EXPECT_TRUE(referee.judge(kNow, segments, image, objects).empty());
}

TEST_F(RefereeOf, FalseSegmentsShowNoObjectWithHalfOfTheirPixels) {
  Referee referee = this->referee();
  const auto floor = pixels(60, 100), part_of_mug = pixels(0, 5), much_else = pixels(30, 100), found = pixels(0, 38);
  const std::vector<JudgedSegment> segments{
      {floor, kAtMug}, {part_of_mug, kAtMug}, {much_else, kAtMug}, {found, kAtMug}};
  EXPECT_EQ(referee.judge(kNow, segments, image, objects).size(), 1U);
  EXPECT_EQ(referee.segments(), 4);
  EXPECT_EQ(referee.false_segments(), 2) << "the floor, and 20 pixels of the ball and 10 of the mug among 70";
  EXPECT_TRUE(referee.judge(kNow, segments, image, objects).empty());
  EXPECT_EQ(referee.segments(), 8);
  EXPECT_EQ(referee.false_segments(), 4) << "a segment of what was found before is not false";
}

TEST_F(RefereeOf, TheNearestOfSeveralSegmentsCounts) {
  Referee referee = this->referee();
  const auto mask = pixels(0, 30);
  const std::vector<JudgedSegment> segments{{mask, {{1.5, 2.0, 0.05}}}, {mask, kAtMug}, {mask, {{1.09, 2.0, 0.05}}}};
  EXPECT_EQ(referee.judge(kNow, segments, image, objects).size(), 1U);
  EXPECT_NEAR(referee.verdicts().front().error_m, 0.03, 1e-12);
}

TEST_F(RefereeOf, WhereItIsNowCounts) {
  Referee referee = this->referee();
  objects[0] = object("mug", kMug, {11.5, 2.0, 0.05});  // it was pushed
  const auto mask = pixels(0, 40);
  const std::vector<JudgedSegment> segments{{mask, kAtMug}};
  EXPECT_TRUE(referee.judge(kNow, segments, image, objects).empty());
  EXPECT_NEAR(referee.verdicts().front().position_world.x(), 11.5, 1e-12);
}

TEST_F(RefereeOf, AllFound) {
  Referee referee = this->referee();
  const auto mug = pixels(0, 40), ball = pixels(40, 60);
  const std::vector<JudgedSegment> segments{{mug, kAtMug}, {ball, {{3.0, 2.05, 0.05}}}};
  EXPECT_EQ(referee.judge(kNow, segments, image, objects), (std::vector<std::string>{"mug", "ball"}));
  EXPECT_TRUE(referee.all_found());
}

TEST_F(RefereeOf, FalseRegionsHoldNoObject) {
  const Referee referee = this->referee();
  EXPECT_FALSE(referee.is_false({{1.0, 2.0, 0.0}}, 0.1, objects));
  EXPECT_FALSE(referee.is_false({{1.24, 2.0, 0.0}}, 0.1, objects)) << "touches bounds grown by the margin";
  EXPECT_TRUE(referee.is_false({{1.26, 2.0, 0.0}}, 0.1, objects));
  EXPECT_TRUE(referee.is_false({{2.0, 2.0, 0.0}}, 0.3, objects)) << "between the two";
}

TEST(RefereeParams, AreDescribed) {
  RefereeParams params;
  ParamTable table;
  describe(table, params);
  EXPECT_EQ(table.rows().size(), 4U);
  for (const ParamTable::Row& row : table.rows()) EXPECT_TRUE(row.parse(row.print())) << row.key;
}

}  // namespace
}  // namespace amiss::score
