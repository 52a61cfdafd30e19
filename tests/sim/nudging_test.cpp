#include "sim/nudging.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/furnished.hpp"
#include "sim/physics.hpp"

namespace amiss::sim {
namespace {

const world::Nudge* of(const std::vector<world::Nudge>& nudges, const std::string& body) {
  const auto found = std::find_if(nudges.begin(), nudges.end(), [&](const auto& n) { return n.body == body; });
  return found == nudges.end() ? nullptr : &*found;
}

TEST(Nudging, FurnitureMovesByCentimetresWithWhatStandsOnItAndNothingElseMoves) {
  const world::World world = test::furnished_room();
  const NudgingParams params{.part = 1.0, .thing_shift_m = 0.0, .thing_yaw_rad = 0.0};
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    RandomStream random(seed, "test/nudging");
    const auto nudges = random_nudges(world, test::classes(), params, random);
    for (const world::Nudge& nudge : nudges) {
      EXPECT_TRUE(nudge.body == "table_1" || nudge.body == "monitor_1" || nudge.body == "bench_1") << nudge.body;
    }
    const world::Nudge* table = of(nudges, "table_1");
    const world::Nudge* monitor = of(nudges, "monitor_1");
    if (table == nullptr) continue;
    ++moved;
    EXPECT_LE(table->shift_m.cwiseAbs().maxCoeff(), 0.03);
    EXPECT_LE(std::abs(table->yaw_rad), radians(2.0));
    ASSERT_NE(monitor, nullptr);
    EXPECT_NEAR(monitor->yaw_rad, table->yaw_rad, 1e-9);
    // As one rigid body: where the monitor was in the table's frame it still is.
    const world::World now = world::nudged(world, nudges);
    const auto relative = [](const world::World& w) {
      return (w.bodies[5].pose.T.inverse() * w.bodies[6].pose.T).matrix().eval();
    };
    EXPECT_TRUE(relative(world).isApprox(relative(now), 1e-9));
  }
  EXPECT_GE(moved, 3);
}

TEST(Nudging, NothingIsPushedIntoSomethingElse) {
  world::World world = test::room(2, 2);
  world.bodies.push_back(test::block("bench_1", {0.4, 0.4, 0.4}, {1.0, 1.0, 0.2}));
  world.bodies.push_back(test::block("bench_2", {0.4, 0.4, 0.4}, {1.41, 1.0, 0.2}));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed, "test/nudging");
    world::World now =
        world::nudged(world, random_nudges(world, test::classes(), {.part = 1.0, .furniture_shift_m = 0.1}, random));
    now.bodies[5].is_static = false;
    const auto gap_m = Physics(now).distance_to_others(5, 0.05);
    EXPECT_GT(gap_m.value_or(0.05), -0.0025) << seed;
  }
}

}  // namespace
}  // namespace amiss::sim
