#include "view/frontier.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "motion/test_flat.hpp"

namespace amiss::view {
namespace {

std::vector<float> distance_from(const FloorGrid& grid, const Eigen::Vector2d& robot) {
  std::vector<float> travel(grid.cells().size(), std::numeric_limits<float>::infinity());
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.at(Cell{x, y}) != Occupancy::kFree) continue;
      travel[grid.index({x, y})] = static_cast<float>((grid.centre_of({x, y}) - robot).norm());
    }
  }
  return travel;
}

/// A room of 6 x 4 m of which the part right of x = 4 is unknown, but for a strip at the top.
FloorGrid half_known() {
  FloorGrid grid = empty_room(6.0, 4.0);
  fill_rect(grid, 4.0, 0.0, 6.0, 3.0, Occupancy::kUnknown);
  return grid;
}

TEST(Frontiers, LieBetweenFreeAndUnknownWithAGoalThatFacesThem) {
  const FloorGrid grid = half_known();
  const auto found = frontiers(grid, distance_from(grid, {1.0, 2.0}), {});
  ASSERT_EQ(found.size(), 1U);  // the edge and the bottom of the strip touch
  EXPECT_NEAR(found[0].length_m, 5.0, 0.15);
  for (const Cell c : found[0].cells) EXPECT_EQ(grid.at(c), Occupancy::kFree);
  EXPECT_EQ(grid.at(found[0].goal.position()), Occupancy::kFree);
  EXPECT_LE((found[0].goal.position() - found[0].middle_m).norm(), 1.0);
}

TEST(Frontiers, GoalsAreWhereTheRobotCanBe) {
  const FloorGrid grid = half_known();
  auto travel = distance_from(grid, {1.0, 2.0});
  const auto gap = distance_to_occupied_m(grid, true);
  for (std::size_t i = 0; i < travel.size(); ++i) {
    if (gap[i] < 0.325F) travel[i] = std::numeric_limits<float>::infinity();
  }
  const auto found = frontiers(grid, travel, {});
  ASSERT_EQ(found.size(), 1U);
  const Frontier& f = found[0];
  EXPECT_TRUE(std::isfinite(travel[grid.index(grid.cell_at(f.goal.position()))]));
  const Eigen::Vector2d ahead = f.middle_m - f.goal.position();
  EXPECT_NEAR(f.goal.yaw_rad, std::atan2(ahead.y(), ahead.x()), 1e-9);
  const std::vector<float> nowhere(travel.size(), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(frontiers(grid, nowhere, {}).empty());
}

TEST(Frontiers, LongAndNearOnesComeFirst) {
  FloorGrid grid = empty_room(10.0, 4.0);
  fill_rect(grid, 9.0, 0.0, 10.0, 4.0, Occupancy::kUnknown);
  fill_rect(grid, 0.0, 1.0, 0.5, 3.0, Occupancy::kUnknown);
  fill_rect(grid, 5.0, 3.95, 5.05, 4.0, Occupancy::kUnknown);  // a gap in the scan
  FrontierParams params;
  auto found = frontiers(grid, distance_from(grid, {1.0, 2.0}), params);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_LT(found[0].middle_m.x(), 1.0);
  found = frontiers(grid, distance_from(grid, {8.0, 2.0}), params);
  EXPECT_GT(found[0].middle_m.x(), 8.0);
  params.travel_weight = 0.0;
  found = frontiers(grid, distance_from(grid, {1.0, 2.0}), params);
  EXPECT_GT(found[0].middle_m.x(), 8.0);
}

TEST(Frontiers, AFullMapHasNone) {
  const FloorGrid grid = test_flat();
  EXPECT_TRUE(frontiers(grid, distance_from(grid, {1.0, 4.0}), {}).empty());
}

RC_GTEST_PROP(Frontiers, EveryFrontierCellIsInExactlyOneCluster, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "frontier");
  FloorGrid grid(0.1, {0, 0}, 20, 15);
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 20; ++x) grid.set({x, y}, static_cast<Occupancy>(random.below(3)));
  }
  FrontierParams params;
  params.min_length_m = 0.0;
  std::vector<int> times(grid.cells().size(), 0);
  for (const Frontier& f : frontiers(grid, std::vector<float>(grid.cells().size(), 0.0F), params)) {
    for (const Cell c : f.cells) ++times[grid.index(c)];
  }
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 20; ++x) {
      bool beside = false;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const Cell c{x + dx, y + dy};
        beside = beside || (grid.contains(c) && grid.at(c) == Occupancy::kUnknown);
      }
      const bool is = beside && grid.at(Cell{x, y}) == Occupancy::kFree;
      RC_ASSERT(times[grid.index({x, y})] == (is ? 1 : 0));
    }
  }
}

}  // namespace
}  // namespace amiss::view
