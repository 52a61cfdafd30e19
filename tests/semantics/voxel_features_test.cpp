#include "semantics/voxel_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/result.hpp"
#include "semantics/internal/moments.hpp"
#include "semantics/internal/summed_volume.hpp"
#include "semantics/labelled_room.hpp"

namespace amiss::semantics {
namespace {

TEST(VoxelFeatures, AreFiniteAndTheSameForAnyNumberOfThreads) {
  const auto room = test::labelled_room(1);
  const VoxelFeatures one = voxel_features(room.cloud, 0.02, 1), three = voxel_features(room.cloud, 0.02, 3);
  EXPECT_EQ(one.values, three.values);
  ASSERT_EQ(one.values.size(), one.voxels.size() * kFeatureCount);
  EXPECT_TRUE(std::all_of(one.values.begin(), one.values.end(), [](float v) { return std::isfinite(v); }));
}

/// By whole cells of the largest grid, and in steps that a float holds, so that all points fall into the same cells.
TEST(VoxelFeatures, DoNotDependOnThePlaceInTheHouse) {
  auto room = test::labelled_room(2);
  for (Eigen::Vector3f& p : room.cloud.points) p = (p * 256.0F).array().round() / 256.0F + 1.0F / 1024.0F;
  const VoxelFeatures here = voxel_features(room.cloud, 0.02, 2);
  for (Eigen::Vector3f& p : room.cloud.points) p += Eigen::Vector3f(16.0F, -8.0F, 0);
  const VoxelFeatures there = voxel_features(room.cloud, 0.02, 2);
  ASSERT_EQ(there.voxels.of_point, here.voxels.of_point);
  for (std::size_t i = 0; i < here.values.size(); ++i) ASSERT_NEAR(there.values[i], here.values[i], 2e-3F) << i;
}

TEST(VoxelFeatures, ThingsOnTheTableAreAboveIt) {
  const auto room = test::labelled_room(3);
  const VoxelFeatures features = voxel_features(room.cloud, 0.02, 2);
  std::vector<float> floor, ball;
  for (std::size_t i = 0; i < room.classes.size(); ++i) {
    const float above_support = features.of(features.voxels.of_point[i])[kFeatureCount - 5];
    if (room.classes[i] == SemanticClass::kFloor) floor.push_back(above_support);
    if (room.classes[i] == SemanticClass::kOtherProp && room.cloud.points[i].z() > 0.8F) ball.push_back(above_support);
  }
  std::sort(floor.begin(), floor.end());
  EXPECT_NEAR(floor[floor.size() / 2], 0.0F, 0.03F);
  for (const float height : ball) {
    EXPECT_GT(height, 0.0F);
    EXPECT_LT(height, 0.16F);
  }
}

TEST(VoxelFeatures, OfACloudWithoutColoursAndNormals) {
  auto room = test::labelled_room(4);
  room.cloud.colours.clear();
  room.cloud.normals.clear();
  const VoxelFeatures features = voxel_features(room.cloud, 0.02, 2);
  for (std::size_t i = 0; i < room.classes.size(); ++i) {
    const Eigen::Vector3f& p = room.cloud.points[i];
    const bool inside = p.x() > 0.3F && p.x() < 1.3F && p.y() > 0.3F && p.y() < 1.3F;
    if (room.classes[i] != SemanticClass::kFloor || !inside) continue;
    EXPECT_GT(features.of(features.voxels.of_point[i])[1], 0.9F);  // up
  }
}

TEST(VoxelFeatures, OfNothing) { EXPECT_TRUE(voxel_features({}, 0.02, 2).values.empty()); }

TEST(VoxelFeatures, ACloudSpreadOverKilometresIsRefused) {
  EXPECT_THROW((void)voxel_features({{{0, 0, 0}, {4000, 4000, 0}}, {}, {}}, 0.02, 1), ArgumentError);
}

TEST(Surroundings, MomentsOfAFlatPatch) {
  Cloud<Map> cloud;
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < 60; ++y) {
      cloud.points.emplace_back(0.01F + 0.02F * static_cast<float>(x), 0.01F + 0.02F * static_cast<float>(y), 0.01F);
    }
  }
  const Voxels voxels = voxels_of(cloud, 0.02);
  const Surroundings around = surroundings_of(voxels, 0.08, 1);
  const Surrounding& middle = around.at(30 * 60 + 30);
  EXPECT_FLOAT_EQ(middle.voxels, 144.0F);  // 12 x 12
  EXPECT_NEAR(std::abs(middle.normal.z()), 1.0F, 1e-4F);
  EXPECT_NEAR(middle.variances[0], 0.0F, 1e-7F);
  EXPECT_NEAR(middle.variances[1], 0.02F * 0.02F * (12 * 12 - 1) / 12, 1e-5F);
}

TEST(SummedVolume, CountsAsOneDoesByHand) {
  RandomStream random(1, "volume");
  const Eigen::Vector3i size(7, 5, 9);
  SummedVolume volume(size);
  std::vector<Eigen::Vector3i> cells;
  const auto below = [&](int limit) { return static_cast<int>(random.below(static_cast<std::uint64_t>(limit))); };
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3i cell(below(7), below(5), below(9));
    volume.set(cell);
    if (std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
  }
  volume.sum_up();
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3i low(below(12) - 3, below(12) - 3, below(12) - 3);
    const Eigen::Vector3i high = low + Eigen::Vector3i(below(8), below(8), below(8));
    const auto inside = [&](const Eigen::Vector3i& c) {
      return (c.array() >= low.array()).all() && (c.array() < high.array()).all();
    };
    EXPECT_EQ(volume.count(low, high), std::count_if(cells.begin(), cells.end(), inside));
  }
}

}  // namespace
}  // namespace amiss::semantics
