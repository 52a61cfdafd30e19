#include "localize/internal/scan_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "localize/flat.hpp"

namespace amiss::localize::internal {
namespace {

const testing::Flat& the_flat() {
  static const testing::Flat flat = testing::Flat::furnished();
  return flat;
}

const DistanceField& the_field() {
  static const DistanceField field(the_flat().grid());
  return field;
}

/// No more points than the search looks at, none of them off the map.
std::vector<Eigen::Vector2d> points_at(const Pose2<World, Base>& truth) {
  RandomStream random(7, "laser");
  return points_of(testing::scan_from(the_flat(), truth, Stamp{}, random), testing::laser_mount(), 80);
}

/// The obvious way: each point's robust cost at its cell's centre, for one pose.
double cost_of(const std::vector<Eigen::Vector2d>& points_base, const AlignmentPrior& prior,
               const Eigen::Vector3d& offset) {
  const Pose2<Map, Base> pose = moved(prior.T_map_base, offset);
  double sum = prior_cost(prior, offset);
  for (const Eigen::Vector2d& p_base : points_base) {
    const Eigen::Vector2d p_map = Eigen::Rotation2Dd(pose.yaw_rad) * p_base + pose.position();
    const FloorGrid& frame = the_field().map();
    const double distance_m =
        the_field().at(frame.centre_of(frame.cell_at(p_map)) + Eigen::Vector2d(1e-9, 1e-9)).distance_m;
    sum += robust_cost(distance_m, kLastKernelM);
  }
  return sum;
}

RC_GTEST_PROP(BestInWindow, HasTheLeastCostOfAllPosesThere, ()) {
  const Pose2<World, Base> truth{3.2, 2.0, *rc::gen::inRange(-31, 31) / 10.0};
  const auto points_base = points_at(truth);
  const auto off = [] { return *rc::gen::inRange(-80, 81) / 1000.0; };
  const AlignmentPrior prior{{truth.x_m + off(), truth.y_m + off(), truth.yaw_rad + off() / 2.0}, 0.2, radians(10.0)};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 175; ++i) {
    const Eigen::Vector3d offset((i % 5 - 2) * 0.05, (i / 5 % 5 - 2) * 0.05, (i / 25 - 3) * 0.015);
    least = std::min(least, cost_of(points_base, prior, offset));
  }
  const auto best = best_in_window(the_field(), points_base, prior);
  RC_ASSERT(!best.empty() && best.size() <= 2U);
  const double found = cost_of(points_base, prior, offset_of(best.front(), prior.T_map_base));
  RC_ASSERT(std::abs(found - least) < 0.01 * least + 1e-6);
  if (best.size() == 2U) {
    RC_ASSERT(cost_of(points_base, prior, offset_of(best.back(), prior.T_map_base)) >= found * 0.99);
    const Eigen::Vector3d apart = offset_of(best.back(), best.front()).cwiseAbs();
    RC_ASSERT(apart.head<2>().maxCoeff() > 0.09 || apart.z() > 0.029);
  }
}

TEST(BestInWindow, IsThePriorWhereNoPointLiesOnTheMap) {
  const AlignmentPrior prior{{-40.0, 3.0, 0.4}, 0.2, radians(10.0)};
  for (const auto& points_base : {std::vector<Eigen::Vector2d>{}, points_at({3.2, 2.0, 0.4})}) {
    const auto best = best_in_window(the_field(), points_base, prior);
    ASSERT_EQ(best.size(), 1U);
    EXPECT_EQ(offset_of(best.front(), prior.T_map_base).norm(), 0.0);
  }
}

TEST(BestInWindow, KeepsToThePriorAlongAFeaturelessWall) {
  FloorGrid corridor(0.05, {0.0, 0.0}, 400, 40, Occupancy::kFree);
  for (int x = 0; x < corridor.width(); ++x) corridor.set({x, 10}, Occupancy::kOccupied);
  std::vector<Eigen::Vector2d> points_base;
  for (int i = -60; i <= 60; ++i) points_base.emplace_back(i * 0.05, -0.75);
  const auto best = best_in_window(DistanceField(corridor), points_base, {{10.0, 1.325, 0.0}, 0.2, radians(10.0)});
  EXPECT_EQ(best.front().x_m, 10.0);
  EXPECT_NEAR(best.front().y_m, 1.275, 1e-9);
  EXPECT_EQ(best.front().yaw_rad, 0.0);
}

}  // namespace
}  // namespace amiss::localize::internal
