#include "motion/path_planner.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <thread>

#include "motion/path_lengths.hpp"
#include "motion/test_flat.hpp"

namespace amiss::motion {
namespace {

using Pose = Pose2<Map, Base>;

const DriveMap& flat() {
  static const DriveMap map(test_flat(), {});
  return map;
}

Pose random_pose(const DriveMap& map, RandomStream& random) {
  while (true) {
    const double x = random.uniform(0, 12);
    const Eigen::Vector2d p(x, random.uniform(0, 7.5));
    if (map.passable(map.grid().cell_at(p))) return {p.x(), p.y(), random.uniform(-3, 3)};
  }
}

NavigationError error_of(const Pose& start, const Pose& goal) {
  RandomStream random(1, "error");
  const auto planned = plan_path(flat(), start, goal, {}, random);
  EXPECT_FALSE(planned);
  return planned.why();
}

TEST(PathPlanner, TellsWhyThereIsNoPath) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of({50, 0, 0}, {4, 4, 0}), NavigationError::kStartOutsideMap);
  EXPECT_EQ(error_of({nan, 0, 0}, {4, 4, 0}), NavigationError::kStartOutsideMap);
  EXPECT_EQ(error_of({4, 4, 0}, {-50, 4, 0}), NavigationError::kGoalOutsideMap);
  EXPECT_EQ(error_of({4, 4, 0}, {4, nan, 0}), NavigationError::kGoalOutsideMap);
  EXPECT_EQ(error_of({11.9, 0.3, 0}, {4, 4, 0}), NavigationError::kStartOccupied);
  EXPECT_EQ(error_of({4, 4, 0}, {0.5, 2.0, 0}), NavigationError::kGoalOccupied);
  EXPECT_EQ(to_string(NavigationError::kGoalOccupied), "goal_occupied");
}

TEST(PathPlanner, TellsThatARoomIsClosed) {
  FloorGrid grid = test_flat();
  fill_rect(grid, 4.9, 3.2, 5.2, 4.3, Occupancy::kOccupied);
  const DriveMap map(grid, {});
  RandomStream random(1, "closed");
  const auto planned = plan_path(map, {4, 4, 0}, {9, 6, 0}, {}, random);
  ASSERT_FALSE(planned);
  EXPECT_EQ(planned.why(), NavigationError::kNoPath);
}

TEST(PathPlanner, MovesABlockedGoalWhenThatIsAllowed) {
  RandomStream random(1, "goal");
  PlannerParams params;
  params.goal_tolerance_m = 0.8;
  const auto planned = plan_path(flat(), {4, 4, 0}, {0.7, 2.0, 1.0}, params, random);
  ASSERT_TRUE(planned);
  EXPECT_GT(planned->goal_moved_m, 0.1);
  EXPECT_LE(planned->goal_moved_m, 0.8);
  EXPECT_NEAR((planned->path.points_m.back() - Eigen::Vector2d(0.7, 2.0)).norm(), planned->goal_moved_m, 1e-9);
  EXPECT_DOUBLE_EQ(planned->path.final_yaw_rad, 1.0);
}

TEST(PathPlanner, EscapesFromTheInflation) {
  RandomStream random(1, "escape");
  const auto planned = plan_path(flat(), {0.15, 4.5, 0}, {4.0, 4.0, 0}, {}, random);
  ASSERT_TRUE(planned);
  EXPECT_TRUE(planned->escaped);
  EXPECT_EQ(planned->path.points_m.front(), Eigen::Vector2d(0.15, 4.5));
  EXPECT_GE(planned->min_clearance_m, 0.3 - 1e-5);
}

TEST(PathPlanner, StaysWhereItIsWhenTheGoalIsHere) {
  RandomStream random(1, "here");
  const auto planned = plan_path(flat(), {4, 4, 0}, {4, 4, 1}, {}, random);
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->path.length_m(), 0.0);
}

RC_GTEST_PROP(PathPlanner, KeepsItsDistanceAndIsHardlyLongerThanNeeded, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "plan");
  const Pose start = random_pose(flat(), random), goal = random_pose(flat(), random);
  const PathLengths lengths(flat(), start.position());
  const auto planned = plan_path(flat(), start, goal, {}, random);
  const double way_m = static_cast<double>(lengths.to(goal.position()));
  RC_ASSERT(static_cast<bool>(planned) == std::isfinite(way_m));
  if (!planned) return;
  RC_ASSERT(planned->path.points_m.front() == start.position());
  RC_ASSERT(planned->path.points_m.back() == goal.position());
  RC_ASSERT(planned->min_clearance_m >= 0.3 - 1e-5);
  RC_ASSERT(planned->cost_m <= planned->grid_cost_m + 1e-9);
  RC_ASSERT(planned->path.length_m() <= 1.15 * way_m + 0.2);
}

TEST(PathPlanner, PrefersTheMiddleOfADoor) {
  RandomStream random(1, "door");
  const auto planned = plan_path(flat(), {6.3, 3.75, 0}, {6.9, 2.0, 0}, {}, random);
  ASSERT_TRUE(planned);
  for (std::size_t i = 1; i < planned->path.points_m.size(); ++i) {
    const Eigen::Vector2d a = planned->path.points_m[i - 1], b = planned->path.points_m[i];
    if ((a.y() - 3.05) * (b.y() - 3.05) > 0) continue;
    const double x = a.x() + (3.05 - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    EXPECT_NEAR(x, 6.45, 0.10);
  }
}

TEST(PathPlanner, IsRepeatableInAnyThread) {
  const auto plan = [] {
    RandomStream random(7, "repeat");
    std::vector<Eigen::Vector2d> points;
    for (const Pose& goal : {Pose{9, 6, 0}, Pose{6.5, 1.5, 0}, Pose{1.4, 3.5, 0}}) {
      const auto planned = plan_path(flat(), {4, 6.5, 0}, goal, {}, random);
      points.insert(points.end(), planned->path.points_m.begin(), planned->path.points_m.end());
    }
    return points;
  };
  const auto first = plan();
  EXPECT_EQ(first, plan());
  std::vector<Eigen::Vector2d> second, third;
  std::thread a([&] { second = plan(); }), b([&] { third = plan(); });
  a.join();
  b.join();
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, third);
}

}  // namespace
}  // namespace amiss::motion
