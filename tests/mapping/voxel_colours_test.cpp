#include "mapping/voxel_colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/result.hpp"
#include "mapping/synthetic.hpp"

namespace amiss::mapping {
namespace {

const Transform<Map, Camera> kAhead = camera_pose(0, 0, 0, 0, 0);

TEST(VoxelColours, AreMeansOfThePixelsThatEndInThem) {
  VoxelColours colours(0.05, 0.1, 2.0);
  colours.insert(wall_frame(1.02f, {100, 0, 7}), kAhead);
  colours.insert(wall_frame(1.02f, {200, 1, 7}), kAhead);
  EXPECT_EQ(colours.at({20, 0, 0}), (Rgb{150, 1, 7}));
  EXPECT_FALSE(colours.at({19, 0, 0}));
}

TEST(VoxelColours, FarNearAndMissingPixelsDoNotCount) {
  VoxelColours colours(0.05, 0.1, 2.0);
  for (const float depth : {2.5f, 0.05f, std::numeric_limits<float>::quiet_NaN()}) {
    colours.insert(wall_frame(depth, {1, 2, 3}), kAhead);
    EXPECT_FALSE(colours.at({static_cast<int>(depth / 0.05f), 0, 0}));
  }
}

TEST(VoxelColours, RefusesPixelsWithoutColour) {
  VoxelColours colours(0.05, 0.1, 2.0);
  RgbdFrame frame = wall_frame(1.0f, {});
  frame.colour.pop_back();
  EXPECT_THROW(colours.insert(frame, kAhead), InputError);
}

TEST(OccupiedCloud, IsTheSideThatWasSeen) {
  VoxelMapParams params;
  params.min_end_points = 2;
  VoxelMap map(params);
  VoxelColours colours(params.resolution_m, params.min_range_m, params.max_range_m);
  const RgbdFrame wall = wall_frame(1.02f, {9, 99, 199});
  map.insert(wall, kAhead);
  colours.insert(wall, kAhead);
  map.set({100, 100, 100}, Occupancy::kOccupied);  // nothing free beside it
  const Cloud<Map> cloud = occupied_cloud(map, colours);
  ASSERT_GT(cloud.points.size(), 100U);
  EXPECT_LT(cloud.points.size(), map.counts().occupied);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    EXPECT_NEAR(cloud.points[i].x(), 1.025f, 1e-4f);
    EXPECT_LT(cloud.normals[i].x(), -0.5f) << "towards the camera";
    EXPECT_EQ(cloud.colours[i], (Rgb{9, 99, 199}));
  }
}

}  // namespace
}  // namespace amiss::mapping
