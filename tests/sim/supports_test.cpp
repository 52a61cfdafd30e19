#include "sim/supports.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "sim/rooms.hpp"

namespace amiss::sim {
namespace {

TEST(Supports, LevelTopsOfStaticBoxesAndDiscsCount) {
  world::World world = test::room(4, 4);
  world.bodies.push_back(test::block("table", {1.0, 0.6, 0.04}, {2.0, 2.0, 0.72}));
  world.bodies.push_back(test::body("round", world::Cylinder{0.4, 0.03}, {1.0, 1.0, 0.50}, true));
  world.bodies.push_back(test::body("crown", world::Cylinder{0.25, 0.35}, {1.0, 3.8, 0.50}, true));  // no table
  world.bodies.push_back(test::block("rail", {1.0, 0.1, 0.04}, {3.0, 3.0, 0.72}));           // too narrow
  world.bodies.push_back(test::block("cupboard", {0.5, 0.5, 2.0}, {3.5, 1.0, 1.0}));         // too high
  world.bodies.push_back(test::block("crate", {0.5, 0.5, 0.4}, {3.0, 0.5, 0.2}, false));     // moves
  world::Body slope = test::block("slope", {0.8, 0.8, 0.04}, {1.0, 3.0, 0.7});
  slope.pose.T.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  world.bodies.push_back(slope);
  world::Body tipped = test::block("tipped", {0.1, 0.8, 0.6}, {0.6, 3.2, 0.4});  // lies on its side
  tipped.pose.T.rotate(Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitY()));
  world.bodies.push_back(tipped);

  const std::vector<Support> supports = find_supports(world);
  ASSERT_EQ(supports.size(), 3U);
  EXPECT_EQ(world.bodies[supports[0].body].name, "table");
  EXPECT_NEAR(supports[0].height_m(), 0.74, 1e-12);
  EXPECT_NEAR(supports[0].area_m2(), 0.6, 1e-12);
  EXPECT_EQ(world.bodies[supports[1].body].name, "round");
  EXPECT_NEAR(supports[1].area_m2(), std::numbers::pi * 0.16, 1e-12);
  EXPECT_EQ(world.bodies[supports[2].body].name, "tipped");
  EXPECT_NEAR(supports[2].height_m(), 0.45, 1e-12);
  EXPECT_NEAR(supports[2].area_m2(), 0.48, 1e-12);
}

TEST(Supports, OverMeansInsideTheRimAlsoWhenTurned) {
  Support top;
  top.half_m = {0.5, 0.2};
  top.T_world_top = Eigen::Translation3d(1.0, 2.0, 0.7) * Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(top.is_over({1.0, 2.45}));
  EXPECT_FALSE(top.is_over({1.45, 2.0}));
  EXPECT_FALSE(top.is_over({1.0, 2.45}, 0.1));
  top.is_round = true;
  top.half_m = {0.3, 0.3};
  EXPECT_FALSE(top.is_over({1.25, 2.25}));
  EXPECT_TRUE(top.is_over({1.2, 2.2}));
}

TEST(Supports, AThingStandsOnTheNearestTopUnderItsFoot) {
  world::World world;
  world.bodies.push_back(test::block("board_1", {1.0, 0.4, 0.02}, {0.0, 0.0, 0.49}));
  world.bodies.push_back(test::block("board_2", {1.0, 0.4, 0.02}, {0.0, 0.0, 0.89}));
  const std::vector<Support> supports = find_supports(world);
  EXPECT_EQ(support_under(supports, {0.1, 0.1, 0.905})->body, 1U);
  EXPECT_EQ(support_under(supports, {0.1, 0.1, 0.49})->body, 0U);
  EXPECT_FALSE(support_under(supports, {0.1, 0.1, 0.49}, 0U));
  EXPECT_FALSE(support_under(supports, {0.1, 0.1, 0.60}));
  EXPECT_FALSE(support_under(supports, {0.7, 0.1, 0.50}));
  EXPECT_TRUE(foot_of({Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(2, 4, 5)}).isApprox(Eigen::Vector3d(1, 2, 1)));
}

}  // namespace
}  // namespace amiss::sim
