#include "localize/internal/line_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "localize/flat.hpp"

namespace amiss::localize::internal {
namespace {

std::vector<LinePoint> some_points(int n) {
  std::vector<LinePoint> points;
  for (int i = 0; i < n; ++i) {
    const double angle_rad = *rc::gen::inRange(0, 628) / 100.0;
    points.push_back({{*rc::gen::inRange(-100, 100) / 100.0, *rc::gen::inRange(-100, 100) / 100.0},
                      {std::cos(angle_rad), std::sin(angle_rad)}});
  }
  return points;
}

RC_GTEST_PROP(LineMap, NearestIsTheNearestWhoseNormalAgrees, ()) {
  const auto points = some_points(*rc::gen::inRange(0, 200));
  LineMap map;
  map.add(points, {}, 0.0);
  const LinePoint to = some_points(1).front();
  const double radius_m = *rc::gen::inRange(1, 13) / 100.0;
  double best_m = radius_m;
  bool any = false;
  for (const LinePoint& point : points) {
    if (point.n.dot(to.n) < 0.8 || (point.p - to.p).norm() >= best_m) continue;
    best_m = (point.p - to.p).norm();
    any = true;
  }
  const auto found = map.nearest(to, radius_m);
  RC_ASSERT(found.has_value() == any);
  if (found) RC_ASSERT(std::abs((found->p - to.p).norm() - best_m) < 1e-12);
}

RC_GTEST_PROP(LineMap, WhatWasAddedIsNotNew, ()) {
  const auto points = some_points(*rc::gen::inRange(1, 100));
  LineMap map;
  map.add(points, {0.3, -0.2, 0.7}, 0.05);
  RC_ASSERT(map.size() <= points.size());
  RC_ASSERT(map.new_part(points, {0.3, -0.2, 0.7}, 0.05) == 0.0);
}

TEST(LinePoints, LieOnTheWallsAndLookAtTheLaser) {
  testing::Flat room;
  room.box({0.0, 0.0}, {4.0, 3.0});
  RandomStream random(3, "laser");
  const auto points =
      line_points_of(testing::scan_from(room, {2.0, 1.5, 0.0}, Stamp{}, random), testing::laser_mount());
  ASSERT_GT(points.size(), 600U);
  for (const LinePoint& point : points) {
    const Eigen::Vector2d p = point.p + Eigen::Vector2d(2.0, 1.5);
    const double off = std::min({p.x(), 4.0 - p.x(), p.y(), 3.0 - p.y()});
    EXPECT_LT(std::abs(off), 0.03);
    EXPECT_GT(point.n.dot(Eigen::Vector2d(0.1675, 0.0) - point.p), 0.0);
    EXPECT_NEAR(point.n.norm(), 1.0, 1e-9);
  }
}

RC_GTEST_PROP(LineMap, AlignsAScanToMillimetres, ()) {
  static const testing::Flat flat = testing::Flat::furnished();
  RandomStream random(*rc::gen::inRange<std::uint64_t>(1, 1000), "laser");
  const Pose2<World, Base> first{3.2, 2.0, 0.4}, second{3.3, 2.05, 0.5};
  const auto points_of_pose = [&](const Pose2<World, Base>& pose) {
    return line_points_of(testing::scan_from(flat, pose, Stamp{}, random), testing::laser_mount());
  };
  LineMap map;
  map.add(points_of_pose(first), {first.x_m, first.y_m, first.yaw_rad}, 0.02);
  const auto off = [] { return *rc::gen::inRange(-4, 5) / 100.0; };
  const LineAlignment found =
      map.aligned(points_of_pose(second), {second.x_m + off(), second.y_m + off(), second.yaw_rad + off() / 2.0});
  RC_ASSERT((found.T_map_base.position() - second.position()).norm() < 0.006);
  RC_ASSERT(std::abs(found.T_map_base.yaw_rad - second.yaw_rad) < radians(0.2));
  RC_ASSERT(found.matched_part > 0.7);
}

}  // namespace
}  // namespace amiss::localize::internal
