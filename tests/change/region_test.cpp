#include "change/region.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "core/random.hpp"

namespace amiss::change {
namespace {

using mapping::Voxel;
using mapping::VoxelMap;

RegionParams without_evidence() {
  RegionParams params;
  params.min_hit_frames = 0;
  return params;
}

std::vector<Voxel> box(Voxel low, Voxel high) {
  std::vector<Voxel> voxels;
  for (int x = low.x; x <= high.x; ++x) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int z = low.z; z <= high.z; ++z) voxels.push_back({x, y, z});
    }
  }
  return voxels;
}

/// Joined by pairs at most sqrt(2) apart: every pair is looked at, until nothing changes.
std::vector<std::vector<Voxel>> slow_clusters(std::vector<Voxel> voxels) {
  std::sort(voxels.begin(), voxels.end());
  std::vector<std::size_t> label(voxels.size());
  for (std::size_t i = 0; i < label.size(); ++i) label[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      for (std::size_t j = 0; j < voxels.size(); ++j) {
        const Voxel a = voxels[i], b = voxels[j];
        const int d2 = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
        if (d2 <= 2 && label[j] > label[i]) {
          label[j] = label[i];
          changed = true;
        }
      }
    }
  }
  std::vector<std::vector<Voxel>> groups;
  for (const std::size_t l : std::set<std::size_t>(label.begin(), label.end())) {
    std::vector<Voxel>& group = groups.emplace_back();
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      if (label[i] == l) group.push_back(voxels[i]);
    }
  }
  return groups;
}

RC_GTEST_PROP(Region, ClustersAreWhatPairsSay, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 10000)), "clusters");
  std::set<Voxel> voxels;
  for (int i = 0; i < 60; ++i) {
    const auto index = [&random] { return static_cast<int>(random.below(8)) - 4; };
    voxels.insert({index(), index(), index()});
  }
  std::vector<Voxel> shuffled(voxels.begin(), voxels.end());
  std::reverse(shuffled.begin(), shuffled.end());
  RC_ASSERT(clusters(shuffled) == slow_clusters(shuffled));
}

TEST(Region, IsACylinderAroundItsVoxels) {
  const VoxelMap map;
  const std::vector<Region> found = regions(box({10, -2, 0}, {13, -1, 2}), map, without_evidence());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].centre_m.x(), 0.6, 1e-12);
  EXPECT_NEAR(found[0].centre_m.y(), -0.05, 1e-12);
  EXPECT_NEAR(found[0].radius_m, std::hypot(0.1, 0.05), 1e-12);
  EXPECT_NEAR(found[0].z_low_m, 0.0, 1e-12);
  EXPECT_NEAR(found[0].z_high_m, 0.15, 1e-12);
  EXPECT_EQ(found[0].voxels.size(), 24u);
  EXPECT_EQ(found[0].voxel_centres_m.size(), 24u);
}

TEST(Region, LeavesOutWhatNobodyCouldPickUp) {
  const VoxelMap map;
  const RegionParams params = without_evidence();
  EXPECT_TRUE(regions(box({0, 0, 0}, {0, 0, 0}), map, params).empty());    // one voxel
  EXPECT_TRUE(regions(box({0, 0, 0}, {1, 1, 10}), map, params).empty());   // 0.55 m tall
  EXPECT_EQ(regions(box({0, 0, 0}, {1, 1, 9}), map, params).size(), 1u);   // 0.50 m
  EXPECT_TRUE(regions(box({0, 0, 0}, {12, 1, 1}), map, params).empty());   // 0.65 m across
  EXPECT_EQ(regions(box({0, 0, 0}, {1, 11, 1}), map, params).size(), 1u);  // 0.60 m
  EXPECT_TRUE(regions(box({0, 0, 2}, {1, 1, 3}), map, params).empty());    // begins at 0.10 m
  EXPECT_EQ(regions(box({0, 0, 1}, {1, 1, 3}), map, params).size(), 1u);   // 0.05 m
  EXPECT_TRUE(regions(box({0, 0, 0}, {10, 10, 9}), map, params).empty());  // 1210 voxels
  EXPECT_TRUE(regions({}, map, params).empty());
}

/// One ray for each hit: counts as a frame.
void hit(VoxelMap& map, Voxel v, int frames) {
  for (int i = 0; i < frames; ++i) {
    Cloud<Map> cloud;
    cloud.points.push_back(map.centre_of(v).cast<float>());
    map.insert(cloud, {map.centre_of({v.x, v.y, v.z + 1})});
  }
}

TEST(Region, NeedsFramesThatHitIt) {
  VoxelMap map;
  const std::vector<Voxel> pair{{0, 0, 0}, {1, 0, 0}}, lone{{20, 0, 0}};
  hit(map, pair[0], 3);
  hit(map, pair[1], 2);
  EXPECT_TRUE(regions(pair, map).empty());
  hit(map, pair[1], 1);
  ASSERT_EQ(regions(pair, map).size(), 1u);
  EXPECT_EQ(regions(pair, map)[0].evident_voxels, 2);
  EXPECT_EQ(regions(pair, map)[0].hit_frames, 3);
  hit(map, lone[0], 9);
  EXPECT_TRUE(regions(lone, map).empty());
  hit(map, lone[0], 1);
  EXPECT_EQ(regions(lone, map).size(), 1u);
}

}  // namespace
}  // namespace amiss::change
