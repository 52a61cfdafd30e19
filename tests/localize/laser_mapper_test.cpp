#include "localize/laser_mapper.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "localize/flat.hpp"
#include "localize/localizer.hpp"

namespace amiss::localize {
namespace {

using testing::Drive;
using testing::Flat;

/// The map's frame is the robot's first pose; this carries it into the world.
Pose2<World, Map> world_of(const Drive& drive) {
  const Pose2<World, Base> first = drive.steps.front().truth;
  return {first.x_m, first.y_m, first.yaw_rad};
}

struct Mapped {
  LaserMapper mapper{LaserMapperParams{}};
  double worst_m = 0.0, worst_rad = 0.0, last_m = 0.0, last_rad = 0.0;
};

Mapped map_flat(const Drive& drive) {
  Mapped mapped;
  const Pose2<World, Map> T_world_map = world_of(drive);
  for (const Drive::Step& step : drive.steps) {
    if (!step.has_scan) continue;
    const PoseEstimate estimate = mapped.mapper.update(step.odometry, step.scan, testing::laser_mount());
    const Pose2<World, Base> pose = T_world_map * estimate.T_map_base;
    mapped.last_m = (pose.position() - step.truth.position()).norm();
    mapped.last_rad = std::abs(wrap_angle(pose.yaw_rad - step.truth.yaw_rad));
    mapped.worst_m = std::max(mapped.worst_m, mapped.last_m);
    mapped.worst_rad = std::max(mapped.worst_rad, mapped.last_rad);
  }
  return mapped;
}

double distance_to_walls(const Flat& flat, const Eigen::Vector2d& p) {
  double nearest = 1e9;
  for (const testing::Wall& wall : flat.walls()) {
    const Eigen::Vector2d along = wall.b - wall.a;
    const double t = std::clamp((p - wall.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - wall.a - t * along).norm());
  }
  return nearest;
}

class MapperSeeds : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(MapperSeeds, DriftsLessThanThreeCentimetresOnATourThroughAllRooms) {
  const Flat flat = Flat::furnished();
  const Drive drive = testing::drive(flat, testing::tour(), GetParam());
  Mapped mapped = map_flat(drive);
  EXPECT_LT(mapped.last_m, 0.01);
  EXPECT_LT(mapped.last_rad, radians(0.2));
  EXPECT_LT(mapped.worst_m, 0.03);
  EXPECT_LT(mapped.worst_rad, radians(0.8));

  const FloorGrid grid = mapped.mapper.cleaned_grid();
  const Pose2<World, Map> T_world_map = world_of(drive);
  int occupied = 0, astray = 0, free = 0;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Eigen::Vector2d p =
          (T_world_map.lift().T * Eigen::Vector3d(grid.centre_of({x, y}).x(), grid.centre_of({x, y}).y(), 0.0))
              .head<2>();
      free += grid.at(Cell{x, y}) == Occupancy::kFree ? 1 : 0;
      if (grid.at(Cell{x, y}) != Occupancy::kOccupied) continue;
      ++occupied;
      astray += distance_to_walls(flat, p) > 0.075 ? 1 : 0;
    }
  }
  EXPECT_GT(occupied, 800);
  EXPECT_LT(astray, occupied / 50);
  EXPECT_GT(free * 0.0025, 70.0);
  EXPECT_LT(free * 0.0025, 90.2);
}

INSTANTIATE_TEST_SUITE_P(Seeds, MapperSeeds, ::testing::Values(1, 2, 3, 17));

TEST(LaserMapper, MakesAMapToLocalizeOn) {
  const Flat flat = Flat::furnished();
  Mapped mapped = map_flat(testing::drive(flat, testing::tour(), 1));
  const Drive again = testing::drive(flat, testing::tour(), 2);
  const Pose2<World, Map> T_world_map = world_of(again);  // both drives start at the same place
  Localizer localizer(mapped.mapper.cleaned_grid(), {}, {}, {}, RandomStream(2, "localizer"));
  double sum_m2 = 0.0, sum_rad2 = 0.0;
  for (const Drive::Step& step : again.steps) {
    const PoseEstimate estimate =
        localizer.update(step.odometry, step.has_scan ? &step.scan : nullptr, testing::laser_mount());
    const Pose2<World, Base> pose = T_world_map * estimate.T_map_base;
    sum_m2 += (pose.position() - step.truth.position()).squaredNorm();
    sum_rad2 += std::pow(wrap_angle(pose.yaw_rad - step.truth.yaw_rad), 2);
  }
  const auto n = static_cast<double>(again.steps.size());
  RecordProperty("rms_mm", static_cast<int>(1000.0 * std::sqrt(sum_m2 / n)));
  EXPECT_LT(std::sqrt(sum_m2 / n), 0.02);
  EXPECT_LT(std::sqrt(sum_rad2 / n), radians(0.5));
}

TEST(LaserMapper, StartsAtTheOriginAndFollowsOdometryWhereTheLaserSeesNothing) {
  LaserMapper mapper{LaserMapperParams{}};
  const Flat flat = Flat::furnished();
  RandomStream random(1, "laser");
  const LaserScan scan = testing::scan_from(flat, {3.2, 2.0, 0.3}, Stamp{}, random);
  const PoseEstimate first = mapper.update({Stamp{}, {5.0, -2.0, 1.0}}, scan, testing::laser_mount());
  EXPECT_TRUE(first.converged);
  EXPECT_NEAR(first.T_map_base.position().norm(), 0.0, 1e-9);
  EXPECT_NEAR(first.T_map_base.yaw_rad, 0.0, 1e-9);
  LaserScan nothing = scan;
  nothing.ranges_m.assign(nothing.ranges_m.size(), std::nanf(""));
  const Pose2<Odom, Base> ahead = Pose2<Odom, Base>{5.0, -2.0, 1.0} * Pose2<Base, Base>{0.5, 0.0, 0.1};
  const PoseEstimate second = mapper.update({Stamp{}, ahead}, nothing, testing::laser_mount());
  EXPECT_FALSE(second.converged);
  EXPECT_NEAR(second.T_map_base.x_m, 0.5, 1e-9);
  EXPECT_NEAR(second.T_map_base.yaw_rad, 0.1, 1e-9);
}

TEST(LaserMapper, IsAFunctionOfItsInputs) {
  const Drive drive = testing::drive(Flat::furnished(), {{3.2, 2.0}, {4.8, 1.95}}, 4);
  Mapped a = map_flat(drive), b = map_flat(drive);
  EXPECT_EQ(a.last_m, b.last_m);
  EXPECT_EQ(a.mapper.grid(), b.mapper.grid());
}

TEST(Cleaned, TakesBackWhatStrayBeamsLeft) {
  FloorGrid grid(0.05, {0.0, 0.0}, 12, 6);
  for (int y = 1; y < 5; ++y) {
    for (int x = 1; x < 6; ++x) grid.set({x, y}, Occupancy::kFree);
  }
  for (int y = 0; y < 6; ++y) grid.set({6, y}, Occupancy::kOccupied);
  grid.set({9, 3}, Occupancy::kFree);      // behind the wall
  grid.set({3, 2}, Occupancy::kOccupied);  // alone in free space
  const FloorGrid clean = cleaned(grid, {0.1, 0.1});
  EXPECT_EQ(clean.at(Cell{9, 3}), Occupancy::kUnknown);
  EXPECT_EQ(clean.at(Cell{3, 2}), Occupancy::kFree);
  EXPECT_EQ(clean.at(Cell{6, 3}), Occupancy::kOccupied);
  EXPECT_EQ(clean.at(Cell{2, 2}), Occupancy::kFree);
}

TEST(Cleaned, StartsBesideAHoleUnderTheRobot) {
  FloorGrid grid(0.05, {0.0, 0.0}, 30, 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 30; ++x) {
      const bool under = std::abs(x - 14) <= 1 && std::abs(y - 14) <= 1;
      if (!under) grid.set({x, y}, Occupancy::kFree);
    }
  }
  const FloorGrid clean = cleaned(grid, grid.centre_of({14, 14}));
  EXPECT_EQ(clean.at(Cell{14, 14}), Occupancy::kUnknown);
  EXPECT_EQ(clean.at(Cell{2, 27}), Occupancy::kFree);
}

}  // namespace
}  // namespace amiss::localize
