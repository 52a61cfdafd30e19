#include "mapping/raycast.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"
#include "mapping/internal/traversal.hpp"

namespace amiss::mapping {
namespace {

/// Every voxel of the traversal shares a face with the one before it, and every sampled point lies in one of them.
RC_GTEST_PROP(Raycast, TheTraversalMissesNoVoxel, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 100000)), "raycast");
  const auto point = [&random] {
    return Eigen::Vector3d(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
  };
  const Eigen::Vector3d a = point(), b = random.below(4) == 0 ? Eigen::Vector3d(a.x(), a.y() + 3, a.z()) : point();
  std::vector<Voxel> path;
  traverse(a, b, [&path](Voxel v) {
    path.push_back(v);
    return true;
  });
  for (std::size_t i = 1; i < path.size(); ++i) {
    RC_ASSERT(std::abs(path[i].x - path[i - 1].x) + std::abs(path[i].y - path[i - 1].y) +
                  std::abs(path[i].z - path[i - 1].z) ==
              1);
  }
  for (int i = 0; i <= 1000; ++i) {
    const Eigen::Vector3d p = a + (b - a) * (i / 1000.0);
    const Eigen::Vector3i f = p.array().floor().cast<int>();
    RC_ASSERT(std::find(path.begin(), path.end(), Voxel{f.x(), f.y(), f.z()}) != path.end());
  }
}

TEST(Raycast, StopsAtTheFirstOccupiedVoxel) {
  VoxelMap map;
  map.set({10, 0, 5}, Occupancy::kOccupied);
  const Eigen::Vector3d a(0.02, 0.02, 0.27), b(1.0, 0.02, 0.27);
  EXPECT_EQ(first_blocking(map, a, b, UnknownVoxels::kPass), (Voxel{10, 0, 5}));
  EXPECT_FALSE(line_of_sight(map, a, b));
  EXPECT_TRUE(line_of_sight(map, a, {0.49, 0.02, 0.27}));
  EXPECT_TRUE(line_of_sight(map, a, {1.0, 0.2, 0.27}));
}

TEST(Raycast, UnknownBlocksWhenAsked) {
  VoxelMap map;
  for (int x = 0; x < 10; ++x) map.set({x, 0, 0}, Occupancy::kFree);
  const Eigen::Vector3d a(0.02, 0.02, 0.02);
  EXPECT_TRUE(line_of_sight(map, a, {0.49, 0.02, 0.02}, UnknownVoxels::kBlock));
  EXPECT_EQ(first_blocking(map, a, {0.6, 0.02, 0.02}, UnknownVoxels::kBlock), (Voxel{10, 0, 0}));
  EXPECT_TRUE(line_of_sight(map, a, {0.6, 0.02, 0.02}, UnknownVoxels::kPass));
}

}  // namespace
}  // namespace amiss::mapping
