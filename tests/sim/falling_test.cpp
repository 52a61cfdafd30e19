#include "sim/internal/falling.hpp"

#include <gtest/gtest.h>

#include "sim/rooms.hpp"

namespace amiss::sim::internal {
namespace {

TEST(Falling, ATurnedBodyIsFreeAndItsBoundsTurnWithIt) {
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitX()));
  const Turned result = turned(test::block("brick", {0.1, 0.2, 0.4}, {5, 5, 5}), turn);
  EXPECT_FALSE(result.body.is_static);
  EXPECT_TRUE(result.bounds.sizes().isApprox(Eigen::Vector3d(0.1, 0.4, 0.2), 1e-3));
  EXPECT_NEAR(result.bounds.center().norm(), 0.0, 1e-6);
}

TEST(Falling, HalfOfTheTurnsLeaveAThingUpright) {
  RandomStream random(1, "test/turns");
  int upright = 0;
  for (int i = 0; i < 400; ++i) upright += random_turn(random).linear()(2, 2) > 0.999999 ? 1 : 0;
  EXPECT_NEAR(upright, 200, 40);
}

TEST(Falling, SettlingEndsWithEverythingAsleep) {
  world::World world = test::room(2, 2);
  world.bodies.push_back(test::block("brick", {0.1, 0.2, 0.1}, {1, 1, 0.4}, false));
  Physics physics(world);
  EXPECT_TRUE(settle(physics, 5));
  EXPECT_TRUE(settle(physics));
  EXPECT_NEAR(physics.bounds(5).min().z(), 0.0, 0.005);
}

}  // namespace
}  // namespace amiss::sim::internal
