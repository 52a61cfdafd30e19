#include "localize/internal/distance_field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "localize/flat.hpp"

namespace amiss::localize::internal {
namespace {

double nearest_occupied(const FloorGrid& grid, const Eigen::Vector2d& p) {
  double nearest = 1e9;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.at(Cell{x, y}) == Occupancy::kOccupied) nearest = std::min(nearest, (grid.centre_of({x, y}) - p).norm());
    }
  }
  return nearest;
}

RC_GTEST_PROP(DistanceField, IsTheDistanceToTheNearestOccupiedCell, ()) {
  static const FloorGrid grid = testing::Flat::furnished().grid();
  static const DistanceField field(grid);
  const Eigen::Vector2d p(*rc::gen::inRange(-40, 1140) / 100.0, *rc::gen::inRange(-40, 860) / 100.0);
  const DistanceField::Sample sample = field.at(p);
  RC_ASSERT(std::abs(sample.distance_m - nearest_occupied(grid, p)) < 0.03);
  RC_ASSERT(sample.gradient.norm() < 1.5);
}

TEST(DistanceField, IsFarOutsideOfTheMap) {
  const DistanceField field(testing::Flat::furnished().grid());
  EXPECT_EQ(field.at({-5.0, 1.0}).distance_m, DistanceField::kFar);
  EXPECT_EQ(field.at({-5.0, 1.0}).gradient.norm(), 0.0);
}

TEST(Plausibility, OfNewThingsIsBetweenThatOfWallsAndOfSpaceBehindThem) {
  const DistanceField field(testing::Flat::furnished().grid());  // a wall at x = 4 m
  const Pose2<Map, Base> pose{3.0, 0.5, 0.0};
  const auto of = [&](double range_m) { return plausibility_of(field, {{range_m, 0.0}}, {0.1, 0.0}, pose, 0.1); };
  EXPECT_EQ(of(1.0), 1.0);
  EXPECT_EQ(of(0.6), 0.5);
  EXPECT_EQ(of(1.6), 0.0);
  EXPECT_EQ(plausibility_of(field, {{0.6, 0.0}, {1.6, 0.0}}, {0.1, 0.0}, pose, 0.1), 0.25);
  EXPECT_EQ(plausibility_of(field, {}, {0.1, 0.0}, pose, 0.1), 0.0);
}

/// Aligns a scan from a guess that is off by `offset` (x [m], y [m], yaw [rad]); did it find back?
bool finds_back(double yaw_rad, const Eigen::Vector3d& offset) {
  static const testing::Flat flat = testing::Flat::furnished();
  static const DistanceField field(flat.grid());
  RandomStream random(7, "laser");
  const Pose2<World, Base> truth{3.2, 2.0, yaw_rad};
  const auto points = points_of(testing::scan_from(flat, truth, Stamp{}, random), testing::laser_mount(), 240);
  const Pose2<Map, Base> guess{truth.x_m + offset.x(), truth.y_m + offset.y(), truth.yaw_rad + offset.z()};
  const Pose2<Map, Base> found = aligned(field, points, {guess, 0.2, radians(10.0)});
  return (found.position() - truth.position()).norm() < 0.025 &&
         std::abs(wrap_angle(found.yaw_rad - truth.yaw_rad)) < radians(0.6) && fit_of(field, points, found, 0.1) > 0.9;
}

RC_GTEST_PROP(Aligned, FindsBackFromASmallOffset, ()) {
  const double yaw_rad = *rc::gen::inRange(-31, 31) / 10.0;
  const auto off = [] { return *rc::gen::inRange(-8, 9) / 100.0; };
  RC_ASSERT(finds_back(yaw_rad, {off(), off(), off() / 2.0}));
}

}  // namespace
}  // namespace amiss::localize::internal
