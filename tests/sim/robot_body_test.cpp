#include "sim/robot_body.hpp"

#include <gtest/gtest.h>

#include "sim/collision_log.hpp"
#include "sim/rooms.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;
using test::block;

constexpr double kRadius_m = 0.22;

/// A robot that wants to go on and on with one velocity.
class Driver {
 public:
  Driver(world::World world, const Pose2<amiss::World, Base>& start)
      : model_(test::small_robot()),
        physics_(world),
        links_(model_.link_poses({})),
        pose_(start),
        robot_(physics_, model_, {start, links_}) {}

  void drive(const Eigen::Vector2d& velocity, double yaw_rate, double time_s) {
    for (int i = 0; i < static_cast<int>(time_s * 50); ++i) {
      const Pose2<amiss::World, Base> wanted{pose_.x_m + 0.02 * velocity.x(), pose_.y_m + 0.02 * velocity.y(),
                                             wrap_angle(pose_.yaw_rad + 0.02 * yaw_rate)};
      const RobotStep step = robot_.move({wanted, links_}, 20ms);
      pose_ = step.T_world_base;
      blocked_ = step.blocked;
      now_ += 20ms;
      log_.note(now_, step.touches);
    }
  }

  robot::Model model_;
  Physics physics_;
  std::vector<Eigen::Isometry3d> links_;
  Pose2<amiss::World, Base> pose_;
  RobotBody robot_;
  CollisionLog log_;
  Stamp now_{};
  bool blocked_ = false;
};

TEST(RobotBody, AWallStopsItAndCountsOnce) {
  Driver d(test::room(4, 3), {2, 1.5, 0});
  d.drive({0.3, 0}, 0.0, 15.0);
  EXPECT_TRUE(d.blocked_);
  EXPECT_LE(d.pose_.x_m, 4.0 - kRadius_m);
  EXPECT_GT(d.pose_.x_m, 4.0 - kRadius_m - 0.01);
  EXPECT_NEAR(d.pose_.y_m, 1.5, 1e-6);
  ASSERT_EQ(d.log_.collisions().size(), 1U);
  EXPECT_EQ(d.log_.collisions()[0].body, "wall_east");
  EXPECT_EQ(d.log_.collisions()[0].link, "base_link");
  EXPECT_NEAR(d.log_.collisions()[0].position.p.x(), 4.0, 0.01);
}

TEST(RobotBody, ItComesFreeAgainAndTheNextTouchCountsAnew) {
  Driver d(test::room(4, 3), {3, 1.5, 0});
  d.drive({0.3, 0}, 0.0, 5.0);
  d.drive({-0.3, 0}, 0.0, 2.0);
  EXPECT_FALSE(d.blocked_);
  EXPECT_LT(d.pose_.x_m, 3.3);
  d.drive({0.3, 0}, 0.0, 5.0);
  EXPECT_EQ(d.log_.collisions().size(), 2U);
}

TEST(RobotBody, ItSlidesAlongAWall) {
  Driver d(test::room(4, 3), {3.5, 0.5, 0});
  d.drive({0.2, 0.2}, 0.0, 8.0);
  EXPECT_GT(d.pose_.y_m, 1.5);
  EXPECT_LE(d.pose_.x_m, 4.0 - kRadius_m);
}

TEST(RobotBody, FloorsRugsAndTurningOnTheSpotAreNoCollisions) {
  world::World world = test::room(4, 3);
  world.bodies.push_back(block("rug", {1, 1, 0.008}, {2.5, 1.5, 0.004}));
  Driver d(world, {1, 1.5, 0});
  d.drive({0.3, 0}, 0.3, 6.0);
  EXPECT_NEAR(d.pose_.x_m, 2.8, 1e-6);
  EXPECT_TRUE(d.log_.collisions().empty());
}

TEST(RobotBody, AThresholdOfThreeCentimetresStopsIt) {
  world::World world = test::room(4, 3);
  world.bodies.push_back(block("sill", {0.1, 3, 0.03}, {2.5, 1.5, 0.015}));
  Driver d(world, {1, 1.5, 0});
  d.drive({0.3, 0}, 0.0, 8.0);
  EXPECT_LT(d.pose_.x_m, 2.45 - kRadius_m);
  EXPECT_EQ(d.log_.collisions().size(), 1U);
}

TEST(RobotBody, TheHeadMeetsAShelfThatTheBaseWouldPass) {
  world::World world = test::room(4, 3);
  world.bodies.push_back(block("shelf", {0.3, 3, 0.03}, {3, 1.5, 0.95}));
  Driver d(world, {1, 1.5, 0});
  d.drive({0.3, 0}, 0.0, 12.0);
  ASSERT_EQ(d.log_.collisions().size(), 1U);
  EXPECT_EQ(d.log_.collisions()[0].link, "head");
  EXPECT_LT(d.pose_.x_m, 2.85 - 0.1);
}

TEST(RobotBody, ItPushesWhatCanMoveAndCountsThat) {
  world::World world = test::room(6, 3);
  world.bodies.push_back(block("crate", {0.3, 0.3, 0.3}, {2.5, 1.5, 0.15}, false));
  Driver d(world, {1, 1.5, 0});
  d.drive({0.3, 0}, 0.0, 10.0);
  EXPECT_NEAR(d.pose_.x_m, 4.0, 1e-6);
  EXPECT_GT(d.physics_.pose(5).position().x(), 4.0 + kRadius_m + 0.15 - 0.02);
  ASSERT_EQ(d.log_.collisions().size(), 1U);
  EXPECT_EQ(d.log_.collisions()[0].body, "crate");
}

TEST(RobotBody, ItSleepsOnWhileNothingIsNear) {
  world::World world = test::room(6, 3);
  world.bodies.push_back(block("crate", {0.3, 0.3, 0.3}, {5, 2.5, 0.15}, false));
  Driver d(world, {1, 1, 0});
  d.drive({0, 0}, 0.0, 4.0);
  ASSERT_TRUE(d.physics_.all_asleep());
  const std::uint64_t before = d.physics_.revision(5);
  d.drive({0.3, 0}, 0.2, 4.0);
  EXPECT_TRUE(d.physics_.all_asleep());
  EXPECT_EQ(d.physics_.revision(5), before);
}

TEST(RobotBody, WhatStandsInsideOfSomethingMayLeaveButNotGoDeeper) {
  world::World world = test::room(4, 3);
  Driver d(world, {3.85, 1.5, 0});
  EXPECT_FALSE(d.robot_.fits({{3.85, 1.5, 0}, d.links_}));
  EXPECT_TRUE(d.robot_.fits({{3.0, 1.5, 0}, d.links_}));
  d.drive({0.3, 0}, 0.0, 1.0);
  EXPECT_NEAR(d.pose_.x_m, 3.85, 1e-6);
  d.drive({-0.3, 0}, 0.0, 2.0);
  EXPECT_NEAR(d.pose_.x_m, 3.25, 1e-6);
}

TEST(CollisionLog, ContactsWithinHalfASecondAreOne) {
  CollisionLog log;
  const std::vector<Touch> touch{{"base", "wall", {}}};
  for (const auto time : {0ms, 100ms, 600ms, 1100ms}) log.note(Stamp(time), touch);
  EXPECT_EQ(log.collisions().size(), 1U);
  log.note(Stamp(1601ms), touch);
  EXPECT_EQ(log.collisions().size(), 2U);
  log.note(Stamp(1610ms), {{"base", "chair", {}}});
  EXPECT_EQ(log.collisions().size(), 3U);
}

}  // namespace
}  // namespace amiss::sim
