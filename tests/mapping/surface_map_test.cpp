#include "mapping/surface_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/result.hpp"
#include "mapping/surface_scene.hpp"

namespace amiss::mapping {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// 4 cm voxels with a quarter of the pixels are to rays what 1 cm voxels are with all of them.
SurfaceParams coarse_params(double voxel_m = 0.04) {
  SurfaceParams params;
  params.voxel_m = voxel_m;
  return params;
}

SurfaceMap map_of(const SurfaceRecording& r, const SurfaceParams& params = coarse_params()) {
  SurfaceMap map(params);
  for (std::size_t i = 0; i < r.frames.size(); ++i) map.insert(r.frames[i], r.poses[i]);
  return map;
}

const Transform<Map, Camera> kAhead = camera_pose(0, 0, 0, 0, 0);
const Rgb kWood{200, 100, 50};

bool same(const SurfaceMap& a, const SurfaceMap& b) {
  if (a.values().blocks().size() != b.values().blocks().size()) return false;
  for (std::uint32_t slot = 0; slot < a.values().blocks().size(); ++slot) {
    const ValueBlock &x = a.values().blocks()[slot], &y = b.values().blocks()[slot];
    if (x.key != y.key || x.known != y.known || x.occupied != y.occupied || a.free_weight(slot) != b.free_weight(slot))
      return false;
    const SurfaceVoxels *p = a.surface(slot), *q = b.surface(slot);
    if ((p == nullptr) != (q == nullptr)) return false;
    if (p != nullptr && (p->distance_m != q->distance_m || p->weight != q->weight || p->colour != q->colour))
      return false;
  }
  return true;
}

TEST(SurfaceMap, StartsUnknown) {
  const SurfaceMap map;
  EXPECT_EQ(map.at(Voxel{0, 0, 0}), Occupancy::kUnknown);
  EXPECT_EQ(map.at(Eigen::Vector3d(1e12, 0, 0)), Occupancy::kUnknown);
  EXPECT_EQ(map.at(Eigen::Vector3d(0, static_cast<double>(kNothing), 0)), Occupancy::kUnknown);
  EXPECT_FALSE(map.voxel({0, 0, 0}));
  EXPECT_FALSE(map.sample({0, 0, 0}));
  EXPECT_FALSE(map.sample({1e12, 0, 0}));
  EXPECT_EQ(map.surface_blocks(), 0U);
}

TEST(SurfaceMap, AWallIsFreeBeforeAndUnknownBehind) {
  SurfaceMap map;
  map.insert(wall_frame(1.2f, kWood), kAhead);
  EXPECT_EQ(map.at(Eigen::Vector3d(0.3, 0, 0)), Occupancy::kFree);
  EXPECT_EQ(map.at(Eigen::Vector3d(1.175, 0, 0)), Occupancy::kFree);
  EXPECT_EQ(map.at(Eigen::Vector3d(1.205, 0, 0)), Occupancy::kOccupied);
  EXPECT_EQ(map.at(Eigen::Vector3d(1.225, 0, 0)), Occupancy::kUnknown) << "further behind than a voxel";
  EXPECT_EQ(map.at(Eigen::Vector3d(1.6, 0, 0)), Occupancy::kUnknown);
  EXPECT_EQ(map.at(Eigen::Vector3d(-0.2, 0, 0)), Occupancy::kUnknown) << "behind the camera";
  const auto sample = map.sample({1.188, 0.011, -0.02});
  ASSERT_TRUE(sample);
  EXPECT_NEAR(sample->distance_m, 0.012, 1e-4);
  EXPECT_NEAR(sample->gradient.x(), -1.0, 0.01);
  EXPECT_EQ(map.voxel(map.voxel_at({1.205, 0, 0}))->colour, (Rgb{200, 100, 50}));
}

TEST(SurfaceMap, RaysLongerThanTheRangeFreeSpaceUpToIt) {
  SurfaceMap map;
  map.insert(wall_frame(3.0f, kWood), kAhead);
  EXPECT_EQ(map.surface_blocks(), 0U);
  EXPECT_EQ(map.at(Eigen::Vector3d(1.97, 0, 0)), Occupancy::kFree);
  EXPECT_EQ(map.at(Eigen::Vector3d(2.03, 0, 0)), Occupancy::kUnknown);
  EXPECT_EQ(map.voxel(map.voxel_at({1.5, 0, 0}))->distance_m, 0.04f) << "the truncation";
}

TEST(SurfaceMap, PixelsWithoutDepthSayNothing) {
  for (const float depth : {kNothing, 0.0f, 0.05f, -1.0f, std::numeric_limits<float>::infinity()}) {
    SurfaceMap map;
    map.insert(wall_frame(depth, kWood), kAhead);
    EXPECT_TRUE(map.values().blocks().empty()) << depth;
  }
}

TEST(SurfaceMap, WhatIsTakenAwayBecomesFree) {
  SurfaceMap map;
  map.insert(wall_frame(1.0f, kWood), kAhead);
  for (int i = 0; i < 20; ++i) map.insert(wall_frame(1.8f, kWood), kAhead);
  EXPECT_EQ(map.at(Eigen::Vector3d(1.005, 0, 0)), Occupancy::kFree);
  EXPECT_EQ(map.at(Eigen::Vector3d(1.805, 0, 0)), Occupancy::kOccupied);
}

TEST(SurfaceMap, WeightsStopAtTheLargest) {
  SurfaceParams params;
  params.max_weight = 20.0;
  SurfaceMap map(params);
  for (int i = 0; i < 10; ++i) map.insert(wall_frame(1.0f, kWood), kAhead);
  EXPECT_FLOAT_EQ(map.voxel(map.voxel_at({1.005, 0, 0}))->weight, 20.0f);
  EXPECT_FLOAT_EQ(map.voxel(map.voxel_at({0.5, 0, 0}))->weight, 20.0f);
}

TEST(SurfaceMap, CopiesAreIndependent) {
  SurfaceMap map = map_of(surface_recording(1, true, small_camera()));
  const SurfaceMap copy = map;
  EXPECT_TRUE(same(map, copy));
  map.insert(wall_frame(1.0f, kWood), kAhead);
  EXPECT_FALSE(same(map, copy));
  SurfaceMap assigned;
  assigned = copy;
  EXPECT_TRUE(same(assigned, copy));
}

TEST(SurfaceMap, RefusesWhatDoesNotFit) {
  const auto with = [](double SurfaceParams::*field, double value) {
    SurfaceParams params;
    params.*field = value;
    return params;
  };
  EXPECT_THROW(SurfaceMap(with(&SurfaceParams::voxel_m, 0.0)), ArgumentError);
  EXPECT_THROW(SurfaceMap(with(&SurfaceParams::voxel_m, static_cast<double>(kNothing))), ArgumentError);
  EXPECT_THROW(SurfaceMap(with(&SurfaceParams::truncation_voxels, 1.0)), ArgumentError);
  EXPECT_THROW(SurfaceMap(with(&SurfaceParams::max_range_m, 0.05)), ArgumentError);
  EXPECT_THROW(SurfaceMap(with(&SurfaceParams::max_range_m, 100.0)), ArgumentError);
  EXPECT_THROW(SurfaceMap(with(&SurfaceParams::max_weight, -1.0)), ArgumentError);

  SurfaceMap map;
  RgbdFrame frame = wall_frame(1.0f, kWood);
  auto pose = kAhead;
  pose.T.translation().x() = 1e6;
  EXPECT_THROW(map.insert(frame, pose), InputError);
  frame.colour.pop_back();
  EXPECT_THROW(map.insert(frame, kAhead), InputError) << "a pixel without colour";
  frame.depth_m.pop_back();
  EXPECT_THROW(map.insert(frame, kAhead), InputError);
  EXPECT_TRUE(map.values().blocks().empty()) << "as it was";
}

TEST(SurfaceMap, IsAsExactAsTheDepth) {
  const SurfaceMap map = map_of(surface_recording(3, false, CameraIntrinsics{}), coarse_params(0.02));
  const TestScene scene = surface_scene();
  double squares = 0.0;
  int n = 0;
  for (const ValueBlock& block : map.values().blocks()) {
    for_each_bit(block.key, block.occupied, [&](Voxel v) {
      const auto sample = map.sample(map.centre_of(v));
      if (!sample) return;
      const double off = static_cast<double>(sample->distance_m / sample->gradient.norm());
      squares += std::pow(std::min(std::abs(off - distance_to(scene, map.centre_of(v))), 0.02), 2);
      ++n;
    });
  }
  EXPECT_GT(n, 5000);
  EXPECT_LT(std::sqrt(squares / n), 0.0025) << "an eighth of a voxel, edges of furniture included";
}

/// What one frame says of one voxel, by the definition alone: its centre's pixel.
struct Plain {
  Occupancy value = Occupancy::kUnknown;
  bool doubtful = false;  // at a border: of pixels, of values
};
Plain plain_value(const SurfaceParams& params, const RgbdFrame& frame, const Eigen::Vector3d& p) {
  const CameraIntrinsics& k = frame.intrinsics;
  if (p.z() < 0.05) return {Occupancy::kUnknown, p.z() > 0.049};
  const double u = p.x() / p.z() * k.fx + k.cx + 0.5, v = p.y() / p.z() * k.fy + k.cy + 0.5;
  const bool edge = std::abs(u - std::round(u)) < 0.01 || std::abs(v - std::round(v)) < 0.01;
  if (u < 0 || v < 0 || u >= k.width || v >= k.height) return {Occupancy::kUnknown, edge};
  const auto pixel = static_cast<std::size_t>(v) * static_cast<std::size_t>(k.width) + static_cast<std::size_t>(u);
  const double z = static_cast<double>(frame.depth_m[pixel]), stretch = p.norm() / p.z();
  if (!std::isfinite(z) || z < params.min_range_m) return {Occupancy::kUnknown, edge};
  const Eigen::Vector3d ray((std::floor(u) - k.cx) / k.fx, (std::floor(v) - k.cy) / k.fy, 1.0);
  if (z * ray.norm() > params.max_range_m) {
    const double end = std::min(z - params.truncation_m() / ray.norm(), params.max_range_m / ray.norm());
    return {p.z() < end ? Occupancy::kFree : Occupancy::kUnknown, edge || std::abs(p.z() - end) < 1e-4};
  }
  const double distance = (z - p.z()) * stretch, voxel = params.voxel_m;
  const bool border = std::abs(std::abs(distance) - voxel) < 1e-4;
  const Occupancy value =
      distance > voxel ? Occupancy::kFree : (distance >= -voxel ? Occupancy::kOccupied : Occupancy::kUnknown);
  return {value, edge || border};
}

/// Blocks, the pyramid and cubes decided at once must not be seen in the result.
RC_GTEST_PROP(SurfaceMap, SaysOfEachVoxelWhatItsPixelSays, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000)), "surface");
  const auto pose = camera_pose(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3),
                                random.uniform(-1.2, 0.3), random.uniform(0.5, 1.3));
  RgbdFrame frame = exact_frame(random_scene(random, pose), pose, small_camera());
  for (std::size_t i = 0; i < frame.depth_m.size(); i += 1 + random.below(100)) frame.depth_m[i] = kNothing;
  paint(frame);
  const SurfaceParams params = coarse_params(0.02);  // fine enough that no mean of pixels is taken beyond 0.75 m
  SurfaceMap map(params);
  map.insert(frame, pose);
  const Voxel middle = map.voxel_at(pose.position());
  const auto T_camera_map = pose.inverse();
  int known = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto off = [&] { return static_cast<int>(random.uniform(-120, 120)); };
    const Voxel v{middle.x + off(), middle.y + off(), middle.z + off()};
    const Eigen::Vector3d p = T_camera_map.T * map.centre_of(v);
    if (p.z() > 0.0 && p.z() < 0.8) continue;
    const Plain expected = plain_value(params, frame, p);
    if (!expected.doubtful) RC_ASSERT(map.at(v) == expected.value);
    known += expected.value == Occupancy::kUnknown ? 0 : 1;
  }
  RC_PRE(known > 100);  // a camera inside a box sees nothing
}

RC_GTEST_PROP(SurfaceMap, MovesWithTheWorld, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000)), "moved");
  SurfaceRecording r = surface_recording(1, true, small_camera());
  const SurfaceMap map = map_of(r);
  const Voxel by{static_cast<int>(random.below(200)) - 100, static_cast<int>(random.below(200)) - 100, 8};
  const BlockKey blocks{by.x * 8, by.y * 8, by.z * 8};
  r.poses[0].T.translation() += Eigen::Vector3d(blocks.x, blocks.y, blocks.z) * 8 * map.params().voxel_m;
  const SurfaceMap moved = map_of(r);
  std::size_t same_value = 0, all = 0;
  for (const ValueBlock& b : map.values().blocks()) {
    const ValueBlock* other = moved.values().block({b.key.x + blocks.x, b.key.y + blocks.y, b.key.z + blocks.z});
    for (std::size_t layer = 0; layer < kBlockEdge; ++layer) {
      const std::uint64_t known = other == nullptr ? 0 : other->known[layer];
      const std::uint64_t occupied = other == nullptr ? 0 : other->occupied[layer];
      same_value +=
          64U - static_cast<unsigned>(std::popcount((known ^ b.known[layer]) | (occupied ^ b.occupied[layer])));
      all += 64;
    }
  }
  RC_ASSERT(static_cast<double>(all - same_value) < 1e-3 * static_cast<double>(all));
}

TEST(SurfaceMap, SameFramesSameBytes) {
  const SurfaceRecording r = surface_recording(3, true, small_camera());
  EXPECT_TRUE(same(map_of(r), map_of(r)));
}

}  // namespace
}  // namespace amiss::mapping
