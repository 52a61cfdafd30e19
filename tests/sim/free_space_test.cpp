#include "sim/free_space.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "sim/rooms.hpp"

namespace amiss::sim {
namespace {

Occupancy at(const FloorGrid& plan, double x, double y) { return plan.at(Eigen::Vector2d(x, y)); }

TEST(FloorPlan, ShowsWhatReachesIntoTheHeights) {
  world::World world = test::room(4, 3);
  world.bodies.push_back(test::block("box", {0.4, 0.4, 0.5}, {1, 1, 0.25}));
  world.bodies.push_back(test::block("shelf", {0.4, 0.4, 0.05}, {3, 1, 1.5}));
  world.bodies.push_back(test::body("column", world::Cylinder{0.2, 2}, {2, 2, 1}, true));
  world.bodies.push_back(test::block("chair", {0.4, 0.4, 0.5}, {3, 2, 0.25}, false));
  const FloorGrid plan = floor_plan(world, 0.05, 0.02, 1.1, false);
  EXPECT_EQ(at(plan, 1, 1), Occupancy::kOccupied);  // also the inside of solids
  EXPECT_EQ(at(plan, 1.15, 1.15), Occupancy::kOccupied);
  EXPECT_EQ(at(plan, 1.3, 1), Occupancy::kFree);
  EXPECT_EQ(at(plan, 3, 1), Occupancy::kFree);
  EXPECT_EQ(at(plan, 2, 2), Occupancy::kOccupied);
  EXPECT_EQ(at(plan, 2.19, 2.19), Occupancy::kFree);  // the corner of its square
  EXPECT_EQ(at(plan, 3, 2), Occupancy::kFree);
  EXPECT_EQ(at(plan, -0.05, 1.5), Occupancy::kOccupied);
  EXPECT_EQ(at(floor_plan(world, 0.05, 0.02, 1.6, true), 3, 1), Occupancy::kOccupied);
  EXPECT_EQ(at(floor_plan(world, 0.05, 0.02, 1.1, true), 3, 2), Occupancy::kOccupied);
}

TEST(FloorPlan, AMeshMarksItsSurfaces) {
  auto mesh = std::make_shared<world::Mesh>();
  mesh->vertices = {{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {0, 0, 2}};  // an upright sheet
  mesh->indices = {0, 1, 2, 0, 2, 3};
  world::World world = test::room(4, 3);
  world.bodies.push_back(test::body("sheet", world::MeshInstance{mesh, {1, 1, 1}}, {1, 1.52, 0}, true));
  const FloorGrid plan = floor_plan(world, 0.05, 0.02, 1.1, false);
  for (double x = 1.0; x < 3.0; x += 0.05) EXPECT_EQ(at(plan, x, 1.52), Occupancy::kOccupied);
  EXPECT_EQ(at(plan, 2, 1.6), Occupancy::kFree);
  EXPECT_EQ(at(plan, 2, 1.45), Occupancy::kFree);
}

TEST(ConnectedAreas, AWallPartsARoomAndADoorJoinsIt) {
  world::World world = test::room(4, 3);
  world.bodies.push_back(test::block("wall", {0.1, 3, 2}, {2, 1.5, 1}));
  const auto label = [](const FloorGrid& plan, double x, double y) {
    return connected_areas(plan)[plan.index(plan.cell_at({x, y}))];
  };
  const FloorGrid parted = floor_plan(world, 0.05, 0.02, 1.1, false);
  EXPECT_NE(label(parted, 1, 1), 0);
  EXPECT_NE(label(parted, 1, 1), label(parted, 3, 1));
  EXPECT_EQ(label(parted, 2, 1), 0);
  world.bodies.back() = test::block("wall", {0.1, 2, 2}, {2, 1, 1});
  const FloorGrid joined = floor_plan(world, 0.05, 0.02, 1.1, false);
  EXPECT_EQ(label(joined, 1, 1), label(joined, 3, 1));
}

TEST(StandingRoom, IsADiscAwayFromEverything) {
  const FloorGrid room = standing_room(floor_plan(test::room(4, 3), 0.05, 0.02, 1.1, false), 0.3);
  EXPECT_EQ(at(room, 2, 1.5), Occupancy::kFree);
  EXPECT_EQ(at(room, 0.2, 1.5), Occupancy::kOccupied);
  EXPECT_EQ(at(room, 0.4, 1.5), Occupancy::kFree);
}

TEST(FreeStart, TakesTheMiddleOfAnEmptyRoomAndAvoidsWhatStandsThere) {
  world::World world = test::room(4, 3);
  const Pose2<amiss::World, Base> empty = free_start(world, test::small_robot());
  EXPECT_NEAR(empty.x_m, 2.0, 0.1);
  EXPECT_NEAR(empty.y_m, 1.5, 0.1);
  world.bodies.push_back(test::block("table", {1, 1, 0.7}, {2, 1.5, 0.35}));
  const Pose2<amiss::World, Base> beside = free_start(world, test::small_robot());
  EXPECT_GT(std::max(std::abs(beside.x_m - 2.0), std::abs(beside.y_m - 1.5)), 0.75);
}

TEST(FreeStart, AWorldWithoutRoomIsAnError) {
  world::World world = test::room(0.5, 0.5);
  world.bodies.push_back(test::block("filled", {0.5, 0.5, 2}, {0.25, 0.25, 1}));
  EXPECT_THROW((void)free_start(world, test::small_robot()), InputError);
}

}  // namespace
}  // namespace amiss::sim
