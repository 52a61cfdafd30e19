#include "mapping/internal/depth_evidence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mapping/synthetic.hpp"

namespace amiss::mapping {
namespace {

TestScene furnished() {
  TestScene scene;
  scene.boxes = {{{1.213, -0.511, -0.012}, {1.81, 0.413, 0.467}}, {{2.521, -3, -0.012}, {2.6, 3, 2.4}}};
  scene.balls = {{{0.9, 0.3, 0.02}, 0.03}};
  return scene;
}

RC_GTEST_PROP(DepthEvidence, ThePyramidDecidesAsEveryVoxelWould, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000)), "pyramid");
  VoxelMapParams params;
  params.pixel_step = *rc::gen::inRange(1, 4);
  params.max_hit_range_m = *rc::gen::element(1.5, 3.0, 4.0);
  const auto pose = camera_pose(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3),
                                random.uniform(-1.5, 0.5), random.uniform(0.3, 1.3));
  RgbdFrame frame = noisy_frame(exact_frame(furnished(), pose, small_camera()), random);
  for (std::size_t i = 0; i < frame.depth_m.size(); i += 1 + random.below(200)) frame.depth_m[i] = 0.0f;
  DepthEvidence fast, slow;
  const auto& found = fast.look(frame, pose, params, DepthEvidence::Search::kPyramid);
  const auto& expected = slow.look(frame, pose, params, DepthEvidence::Search::kEveryVoxel);
  RC_ASSERT(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    RC_ASSERT(found[i].key == expected[i].key);
    RC_ASSERT(found[i].hit == expected[i].hit);
    RC_ASSERT(found[i].miss == expected[i].miss);
  }
}

/// Every miss is a voxel whose centre lies before the depth of the pixel it projects to; every hit holds end points.
TEST(DepthEvidence, FreesOnlyWhereARayReallyPasses) {
  VoxelMapParams params;
  params.pixel_step = 1;
  params.min_end_fraction = 0.0;
  params.min_end_points = 1;
  const auto pose = camera_pose(0.1, 0.2, 0.3, -0.5);
  const RgbdFrame frame = exact_frame(furnished(), pose, small_camera());
  const CameraIntrinsics& k = frame.intrinsics;
  DepthEvidence kernel;
  std::size_t misses = 0;
  for (const BlockEvidence& block : kernel.look(frame, pose, params)) {
    for_each_bit(block.key, block.miss, [&](Voxel v) {
      const Eigen::Vector3d p_map = (Eigen::Vector3d(v.x, v.y, v.z).array() + 0.5) * params.resolution_m;
      const Eigen::Vector3d p = (pose.inverse() * Point<Map>{p_map}).p;
      const auto u = static_cast<int>(std::lround(k.fx * p.x() / p.z() + k.cx));
      const auto row = static_cast<int>(std::lround(k.fy * p.y() / p.z() + k.cy));
      ASSERT_TRUE(u >= -1 && row >= -1 && u <= k.width && row <= k.height);
      const int at_u = std::clamp(u, 0, k.width - 1), at_v = std::clamp(row, 0, k.height - 1);
      const float depth = frame.depth_m[static_cast<std::size_t>(at_v * k.width + at_u)];
      EXPECT_GT(double{depth} + 0.02, p.z());
      ++misses;
    });
    for (std::size_t l = 0; l < kBlockEdge; ++l) EXPECT_EQ(block.hit[l] & block.miss[l], 0u);
  }
  EXPECT_GT(misses, 10000u);
}

/// Hits are the voxels in which points end, as a plain loop finds them.
TEST(DepthEvidence, HitsWhereEnoughPointsEnd) {
  VoxelMapParams params;
  params.pixel_step = 1;
  params.min_end_fraction = 0.0;
  params.min_end_points = 3;
  const auto pose = camera_pose(0.1, 0.2, 0.3, -0.5);
  const RgbdFrame frame = exact_frame(furnished(), pose, small_camera());
  const CameraIntrinsics& k = frame.intrinsics;
  std::map<Voxel, int> ends;
  for (int v = 0; v < k.height; ++v) {
    for (int u = 0; u < k.width; ++u) {
      const double d = double{frame.depth_m[static_cast<std::size_t>(v * k.width + u)]};
      if (!(d >= params.min_range_m && d <= params.max_hit_range_m)) continue;
      const Eigen::Vector3d p = (pose * Point<Camera>{{(u - k.cx) / k.fx * d, (v - k.cy) / k.fy * d, d}}).p / 0.05;
      ++ends[{static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())),
              static_cast<int>(std::floor(p.z()))}];
    }
  }
  std::size_t hits = 0, wrong = 0;
  DepthEvidence kernel;
  for (const BlockEvidence& block : kernel.look(frame, pose, params)) {
    for_each_bit(block.key, block.hit, [&](Voxel v) {
      ++hits;
      if (ends[v] < 3) ++wrong;
    });
  }
  const auto expected = std::count_if(ends.begin(), ends.end(), [](const auto& e) { return e.second >= 3; });
  EXPECT_NEAR(static_cast<double>(hits), static_cast<double>(expected), 3.0);  // points on a border may round apart
  EXPECT_LE(wrong, 3u);
}

}  // namespace
}  // namespace amiss::mapping
