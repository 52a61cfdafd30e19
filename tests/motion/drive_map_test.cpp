#include "motion/drive_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"
#include "motion/test_flat.hpp"

namespace amiss::motion {
namespace {

TEST(DriveMap, ClearanceIsToTheEdgeOfTheNearestOccupiedCell) {
  const DriveMap map(empty_room(4.0, 4.0), {});
  EXPECT_NEAR(map.clearance_at(Eigen::Vector2d(0.525, 2.0)), 0.525, 1e-6);
  EXPECT_NEAR(map.clearance_at(Eigen::Vector2d(0.5, 2.0)), 0.5, 1e-6);  // between two cells
  EXPECT_NEAR(map.clearance_at(Eigen::Vector2d(2.0, 2.0)), map.params().clearance_cap_m, 1e-6);
  EXPECT_EQ(map.clearance_at(Eigen::Vector2d(100.0, 2.0)), 0.0);
  EXPECT_TRUE(map.passable(map.grid().cell_at({0.325, 2.0})));
  EXPECT_FALSE(map.passable(map.grid().cell_at({0.275, 2.0})));
  EXPECT_FALSE(map.passable(map.grid().cell_at({-0.3, 2.0})));  // unknown
}

TEST(DriveMap, MergesLayersOfAnyGeometry) {
  DriveMap map(empty_room(4.0, 4.0), {});
  FloorGrid same = map.grid();
  fill_rect(same, 1.0, 1.0, 1.2, 1.2, Occupancy::kOccupied);
  FloorGrid fine(0.02, {2.0, 2.0}, 20, 20);
  fine.set({3, 3}, Occupancy::kOccupied);
  FloorGrid coarse(0.5, {-0.5, -0.5}, 10, 10);
  coarse.set({7, 7}, Occupancy::kOccupied);  // 3.0 .. 3.5
  const std::vector<const FloorGrid*> layers{&same, &fine, &coarse};
  map.update(layers, std::vector<Eigen::Vector2d>{{0.52, 3.52}, {99.0, 99.0}});
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(1.1, 1.1)), Occupancy::kOccupied);
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(2.07, 2.07)), Occupancy::kOccupied);
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(3.01, 3.49)), Occupancy::kOccupied);
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(3.51, 3.01)), Occupancy::kFree);
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(0.52, 3.52)), Occupancy::kOccupied);
  EXPECT_GT(map.update({}, {}), 0U);
  EXPECT_EQ(map.grid(), empty_room(4.0, 4.0));
  EXPECT_EQ(map.update({}, {}), 0U);
}

TEST(DriveMap, FreeLayersFillTheUnknownButClearNothing) {
  DriveMap map(empty_room(4.0, 4.0), {});
  FloorGrid free_layer = map.grid();
  fill_rect(free_layer, -1.0, -1.0, 5.0, 5.0, Occupancy::kFree);
  const std::vector<const FloorGrid*> layers{&free_layer};
  map.update(layers, {});
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(-0.3, 2.0)), Occupancy::kFree);
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(-0.05, 2.0)), Occupancy::kOccupied);
}

TEST(DriveMap, AHitBesideAWallIsTheWall) {
  DriveMap map(empty_room(4.0, 4.0), {});
  EXPECT_EQ(map.update({}, std::vector<Eigen::Vector2d>{{0.04, 2.0}, {-0.05, 3.0}}), 0U);
  EXPECT_EQ(map.update({}, std::vector<Eigen::Vector2d>{{0.06, 2.0}, {0.06, 2.05}}), 2U);
}

TEST(DriveMap, AWideUnknownBorderChangesNothing) {
  const FloorGrid room = empty_room(4.0, 4.0);
  FloorGrid wide(0.05, room.origin_m() - Eigen::Vector2d(10.0, 5.0), 600, 500);
  for (int y = 0; y < room.height(); ++y) {
    for (int x = 0; x < room.width(); ++x) wide.set({x + 200, y + 100}, room.at(Cell{x, y}));
  }
  DriveMap small(room, {}), large(wide, {});
  const std::vector<Eigen::Vector2d> hits{{1.02, 1.02}, {-8.0, 0.0}};
  EXPECT_EQ(small.update({}, hits), large.update({}, hits));
  for (int y = 0; y < room.height(); ++y) {
    for (int x = 0; x < room.width(); ++x) {
      EXPECT_EQ(small.grid().at(Cell{x, y}), large.grid().at(Cell{x + 200, y + 100}));
      EXPECT_EQ(small.clearance_at(Cell{x, y}), large.clearance_at(Cell{x + 200, y + 100}));
    }
  }
  EXPECT_LT(large.box().width(), 140);
}

TEST(DriveMap, AnUnknownMapIsPassableNowhere) {
  DriveMap map(FloorGrid(0.05, {0, 0}, 20, 20), {});
  EXPECT_EQ(map.update({}, std::vector<Eigen::Vector2d>{{0.5, 0.5}}), 0U);
  EXPECT_FALSE(map.nearest_passable({0.5, 0.5}, 1.0));
  EXPECT_FALSE(DriveMap(FloorGrid(), {}).nearest_passable({0.5, 0.5}, 1.0));
}

TEST(DriveMap, KeepsFreeWhereTheRobotStands) {
  DriveMap map(empty_room(4.0, 4.0), {});
  map.keep_free({{1.0, 1.0}}, 0.2);
  map.update({}, std::vector<Eigen::Vector2d>{{1.1, 1.0}, {1.4, 1.0}});
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(1.1, 1.0)), Occupancy::kFree);
  EXPECT_EQ(map.grid().at(Eigen::Vector2d(1.4, 1.0)), Occupancy::kOccupied);
}

TEST(DriveMap, NothingIsPassableOutsideOfTheBoxThoughTheRobotBelievesToStandThere) {
  FloorGrid grid(0.05, {0.0, 0.0}, 200, 200);
  for (int y = 80; y < 120; ++y) {
    for (int x = 80; x < 120; ++x) grid.set({x, y}, Occupancy::kFree);
  }
  DriveMap map(grid, {});
  for (const double x_m : {2.5, 2.9, 3.0, 3.1}) {
    map.keep_free({{x_m, 5.0}}, 0.4);
    map.update({}, {});
  }
  int free = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const bool inside =
          x >= map.box().low.x && y >= map.box().low.y && x <= map.box().high.x && y <= map.box().high.y;
      ASSERT_TRUE(inside || map.grid().at(Cell{x, y}) != Occupancy::kFree) << x << " " << y;
      if (inside && map.grid().at(Cell{x, y}) == Occupancy::kFree) ++free;
    }
  }
  EXPECT_GT(free, 1600);
}

RC_GTEST_PROP(DriveMap, UpdatesOfAPartEqualThoseOfAll, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "drive");
  DriveParams params;
  params.clearance_cap_m = random.uniform(0.5, 1.2);
  params.unknown_is_occupied = random.below(2) == 0;
  DriveMap map(empty_room(5.0, 3.0), params);
  for (int round = 0; round < 3; ++round) {
    std::vector<Eigen::Vector2d> hits(random.below(4));
    for (auto& hit : hits) {
      const double x = random.uniform(-0.4, 5.4);
      hit = {x, random.uniform(-0.4, 3.4)};
    }
    map.update({}, hits);
    const DriveMap fresh(map.grid(), params);
    for (std::size_t i = 0; i < map.clearance_m().size(); ++i) {
      RC_ASSERT(std::abs(map.clearance_m()[i] - fresh.clearance_m()[i]) < 1e-5F);
    }
  }
}

RC_GTEST_PROP(DriveMap, NearestPassableIsTheNearest, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "nearest");
  const DriveMap map(empty_room(3.0, 3.0), {});
  const double x = random.uniform(-0.4, 3.4);
  const Eigen::Vector2d p(x, random.uniform(-0.4, 3.4));
  double best = 0.5;
  for (int cy = 0; cy < map.grid().height(); ++cy) {
    for (int cx = 0; cx < map.grid().width(); ++cx) {
      if (map.passable({cx, cy})) best = std::min(best, (map.grid().centre_of({cx, cy}) - p).norm());
    }
  }
  const auto nearest = map.nearest_passable(p, 0.5);
  if (map.passable(map.grid().cell_at(p))) {
    RC_ASSERT(*nearest == map.grid().cell_at(p));
  } else if (nearest) {
    RC_ASSERT(std::abs((map.grid().centre_of(*nearest) - p).norm() - best) < 1e-9);
  } else {
    RC_ASSERT(best == 0.5);
  }
}

TEST(LaserHits, LieWhereTheBeamsEnd) {
  LaserScan scan;
  scan.angle_min_rad = -std::numbers::pi / 2;
  scan.angle_step_rad = std::numbers::pi / 2;
  scan.min_range_m = 0.05;
  scan.max_range_m = 20.0;
  scan.ranges_m = {2.0F, std::numeric_limits<float>::quiet_NaN(), 1.0F, 15.0F, 0.01F};
  Transform<Base, Laser> T_base_laser;
  T_base_laser.T.translate(Eigen::Vector3d(0.2, 0.0, 0.18));
  const auto hits = laser_hits(scan, T_base_laser, 10.0);
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_LT((hits[0] - Eigen::Vector2d(0.2, -2.0)).norm(), 1e-6);
  EXPECT_LT((hits[1] - Eigen::Vector2d(0.2, 1.0)).norm(), 1e-6);
  const auto in_map = laser_hits(scan, {1.0, 1.0, std::numbers::pi / 2}, T_base_laser, 10.0);
  EXPECT_LT((in_map[0] - Eigen::Vector2d(3.0, 1.2)).norm(), 1e-6);
}

}  // namespace
}  // namespace amiss::motion
