#include "motion/path.hpp"

#include <gtest/gtest.h>

#include "motion/test_flat.hpp"

namespace amiss::motion {
namespace {

TEST(Path, KnowsItsLengthAndClearance) {
  const DriveMap map(empty_room(6.0, 3.0), {});
  const Path path{{{1.0, 1.5}, {5.0, 1.5}, {5.0, 0.5}}, 0.0};
  EXPECT_DOUBLE_EQ(path.length_m(), 5.0);
  EXPECT_NEAR(min_clearance_m(map, path), 0.5, 0.03);
  EXPECT_NEAR(min_clearance_m(map, {{{1.0, 1.5}, {5.0, 1.5}}, 0.0}), 1.0, 0.03);
  EXPECT_NEAR(min_clearance_m(map, {{{0.5, 1.5}, {3.0, 1.5}}, 0.0}, 0.2), 0.7, 0.03);  // from there on
  EXPECT_NEAR(min_clearance_m(map, {{{0.5, 1.5}}, 0.0}), 0.5, 0.03);
  EXPECT_EQ(min_clearance_m(map, {}), 0.0);
  EXPECT_EQ(min_clearance_m(map, {{{1.0, 1.5}, {7.0, 1.5}}, 0.0}), 0.0);  // through the wall
}

TEST(Path, StraightLinesArePassableWhereTheRobotFits) {
  const DriveMap map(test_flat(), {});
  EXPECT_TRUE(straight_passable(map, {4.0, 3.75}, {6.0, 3.75}));   // through the door
  EXPECT_FALSE(straight_passable(map, {4.0, 2.0}, {6.0, 2.0}));    // through the wall
  EXPECT_FALSE(straight_passable(map, {4.0, 3.45}, {6.0, 3.45}));  // too near to the door's side
  EXPECT_FALSE(straight_passable(map, {4.0, 3.75}, {40.0, 3.75}));
}

}  // namespace
}  // namespace amiss::motion
