#include "localize/internal/grid_drawing.hpp"

#include <gtest/gtest.h>

#include "localize/flat.hpp"

namespace amiss::localize::internal {
namespace {

TEST(DrawnGrid, FreesWhatBeamsCrossAndOccupiesWhereTheyEnd) {
  testing::Flat room;
  room.box({-2.0, -1.52}, {2.03, 1.53});
  RandomStream random(3, "laser");
  DrawnGrid drawn(0.05, 12.0);
  for (int i = 0; i < 4; ++i) {
    const Pose2<World, Base> truth{0.1 * i, 0.0, 1.5 * i};
    drawn.add(testing::scan_from(room, truth, Stamp{}, random), testing::laser_mount(),
              {truth.x_m, truth.y_m, truth.yaw_rad});
  }
  const FloorGrid& grid = drawn.floor();
  EXPECT_EQ(grid.resolution_m(), 0.05);
  EXPECT_NEAR(std::remainder(grid.origin_m().x(), 0.05), 0.0, 1e-9);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.5, 0.5)), Occupancy::kFree);
  EXPECT_EQ(grid.at(Eigen::Vector2d(2.03, 0.3)), Occupancy::kOccupied);
  EXPECT_EQ(grid.at(Eigen::Vector2d(2.4, 0.3)), Occupancy::kUnknown);
}

}  // namespace
}  // namespace amiss::localize::internal
