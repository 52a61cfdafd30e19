#include "mapping/voxel_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/result.hpp"
#include "mapping/synthetic.hpp"

namespace amiss::mapping {
namespace {

constexpr double kTilt = -0.55;

VoxelMapParams params_of(const std::string& store) {
  VoxelMapParams params;
  params.store = store;
  return params;
}

VoxelMapParams small_params(const std::string& store = "blocks") {
  VoxelMapParams params = params_of(store);
  params.min_end_points = 2;  // with small_camera()
  return params;
}

/// Occupied voxels above the floor.
std::size_t above_floor(const VoxelMap& map) {
  const std::vector<Voxel> all = map.voxels(Occupancy::kOccupied);
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const Voxel& v) { return v.z >= 0; }));
}

std::size_t occupied_in(const VoxelMap& map, Voxel low, Voxel high) {
  std::size_t n = 0;
  for (const Voxel& v : map.voxels(Occupancy::kOccupied)) {
    if (v.x >= low.x && v.x <= high.x && v.y >= low.y && v.y <= high.y && v.z >= low.z && v.z <= high.z) ++n;
  }
  return n;
}

TEST(VoxelMap, StartsUnknownAndKeepsWhatIsSet) {
  for (const char* store : {"blocks", "octomap"}) {
    VoxelMap map(params_of(store));
    const Voxel v{-3, 7, 100};
    EXPECT_EQ(map.at(v), Occupancy::kUnknown);
    EXPECT_FALSE(map.bounds());
    map.set(v, Occupancy::kOccupied);
    map.set({4, 4, 4}, Occupancy::kFree);
    EXPECT_EQ(map.at(v), Occupancy::kOccupied);
    EXPECT_EQ(map.at(map.centre_of(v)), Occupancy::kOccupied);
    EXPECT_DOUBLE_EQ(map.log_odds(v), 3.5);
    EXPECT_EQ(map.counts(), (VoxelCounts{1, 1}));
    EXPECT_EQ(map.bounds(), (VoxelBox{{-3, 4, 4}, {4, 7, 100}}));
    map.set(v, Occupancy::kUnknown);
    EXPECT_EQ(map.at(v), Occupancy::kUnknown);
    EXPECT_EQ(map.counts(), (VoxelCounts{1, 0}));
  }
}

TEST(VoxelMap, CopiesAreIndependent) {
  for (const char* store : {"blocks", "octomap"}) {
    VoxelMap map(params_of(store));
    map.set({1, 2, 3}, Occupancy::kOccupied);
    VoxelMap copy = map;
    copy.set({1, 2, 3}, Occupancy::kFree);
    EXPECT_EQ(map.at(Voxel{1, 2, 3}), Occupancy::kOccupied);
    EXPECT_DOUBLE_EQ(map.log_odds({1, 2, 3}), 3.5);
    EXPECT_EQ(copy.at(Voxel{1, 2, 3}), Occupancy::kFree);
  }
}

TEST(VoxelMap, FarPointsAndPointsThatAreNotNumbersAreUnknown) {
  const VoxelMap map;
  EXPECT_EQ(map.at(Eigen::Vector3d(1e12, 0, 0)), Occupancy::kUnknown);
  EXPECT_EQ(map.at(Eigen::Vector3d(0, std::numeric_limits<double>::quiet_NaN(), 0)), Occupancy::kUnknown);
}

TEST(VoxelMap, TellsTheBlocksThatChanged) {
  VoxelMap map;
  map.set({0, 0, 0}, Occupancy::kOccupied);
  const std::uint64_t before = map.revision();
  map.set({0, 0, 0}, Occupancy::kOccupied);
  EXPECT_EQ(map.revision(), before);
  map.set({20, 0, -1}, Occupancy::kFree);
  EXPECT_EQ(map.blocks_changed_since(before), (std::vector<BlockKey>{{2, 0, -1}}));
  EXPECT_EQ(map.blocks_changed_since(0).size(), 2u);
  EXPECT_TRUE(map.blocks_changed_since(map.revision()).empty());
}

TEST(VoxelMap, AWallIsOccupiedAndTheSpaceBeforeItFree) {
  TestScene scene;
  scene.boxes.push_back({{1.5, -2, -0.012}, {1.6, 2, 2}});
  for (const char* store : {"blocks", "octomap"}) {
    VoxelMap map(small_params(store));
    const auto pose = camera_pose(0.001, 0.002, 0.0, 0.0);
    map.insert(exact_frame(scene, pose, small_camera()), pose);
    EXPECT_EQ(map.at(Eigen::Vector3d(1.52, 0.1, 0.9)), Occupancy::kOccupied);
    EXPECT_EQ(map.at(Eigen::Vector3d(1.0, 0.1, 0.9)), Occupancy::kFree);
    EXPECT_EQ(map.at(Eigen::Vector3d(1.72, 0.1, 0.9)), Occupancy::kUnknown);
    EXPECT_EQ(map.at(Eigen::Vector3d(-0.5, 0.0, 0.9)), Occupancy::kUnknown);
    EXPECT_EQ(map.at(Eigen::Vector3d(0.5, 2.0, 0.9)), Occupancy::kUnknown);
    EXPECT_EQ(map.hit_frames(map.voxel_at({1.52, 0.1, 0.9})), 1);
  }
}

TEST(VoxelMap, PixelsWithoutDepthSayNothing) {
  RgbdFrame frame;
  frame.intrinsics = small_camera();
  frame.depth_m.assign(160 * 120, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < frame.depth_m.size(); i += 3) frame.depth_m[i] = i % 2 == 0 ? 0.0f : -1.0f;
  frame.depth_m[5] = std::numeric_limits<float>::infinity();
  VoxelMap map(small_params());
  map.insert(frame, camera_pose(0, 0, 0, kTilt));
  EXPECT_EQ(map.counts(), VoxelCounts{});
  EXPECT_EQ(map.revision(), 0u);
}

TEST(VoxelMap, FarPixelsFreeNoFurtherThanTheRange) {
  TestScene scene;
  scene.boxes.push_back({{5.0, -9, -0.012}, {5.1, 9, 9}});
  VoxelMap map(small_params());
  const auto pose = camera_pose(0, 0, 0, 0);
  map.insert(exact_frame(scene, pose, small_camera()), pose);
  EXPECT_EQ(above_floor(map), 0u);
  EXPECT_EQ(map.at(Eigen::Vector3d(2.9, 0.01, 0.96)), Occupancy::kFree);
  EXPECT_EQ(map.at(Eigen::Vector3d(3.1, 0.01, 0.96)), Occupancy::kUnknown);
}

TEST(VoxelMap, RefusesFramesThatDoNotFit) {
  VoxelMap map;
  RgbdFrame frame;
  frame.depth_m.assign(17, 1.0f);
  EXPECT_THROW(map.insert(frame, {}), InputError);
  frame.depth_m.assign(640 * 480, 1.0f);
  Transform<Map, Camera> pose;
  pose.T.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(map.insert(frame, pose), InputError);
  pose.T.translation().x() = 1e7;
  EXPECT_THROW(map.insert(frame, pose), InputError);
  EXPECT_THROW(map.insert(Cloud<Map>{}, Point<Map>{pose.position()}), InputError);
  EXPECT_EQ(map.counts(), VoxelCounts{});
  VoxelMapParams params;
  params.store = "paper";
  EXPECT_THROW(VoxelMap{params}, ArgumentError);
  params = {};
  params.min_range_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(VoxelMap{params}, ArgumentError);
}

void expect_same_stores(std::uint64_t seed) {
  RandomStream random(seed, "stores");
  TestScene scene;
  scene.boxes.push_back({{1.5, -0.4, -0.012}, {1.9, 0.6, 0.7}});
  scene.balls.push_back({{1.0, random.uniform(-0.3, 0.3), 0.02}, 0.05});
  VoxelMap fast(small_params("blocks")), oracle(small_params("octomap"));
  for (int i = 0; i < 6; ++i) {
    const auto pose = camera_pose(0.05 * i, 0.02 * i, random.uniform(-3, 3), kTilt);
    const RgbdFrame frame = noisy_frame(exact_frame(scene, pose, small_camera()), random);
    const std::uint64_t before = fast.revision();
    fast.insert(frame, pose);
    oracle.insert(frame, pose);
    ASSERT_EQ(fast.blocks_changed_since(before), oracle.blocks_changed_since(before));
  }
  EXPECT_EQ(fast.counts(), oracle.counts());
  fast.for_each_known([&](Voxel v, Occupancy value) {
    ASSERT_EQ(oracle.at(v), value);
    ASSERT_EQ(fast.log_odds(v), oracle.log_odds(v));
    ASSERT_EQ(fast.hit_frames(v), oracle.hit_frames(v));
  });
}

TEST(VoxelMap, BothStoresGiveTheSameValues) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) expect_same_stores(seed);
}

// The task: floor noise must not become voxels, and the smallest things must.

TEST(VoxelMap, TheNoiseOfTheFloorStaysUnderTheFirstLayer) {
  const TestScene empty;
  RandomStream random(7, "floor");
  VoxelMap map;
  std::size_t evident = 0;
  for (int i = 0; i < 40; ++i) {
    const auto pose = camera_pose(0.05 * i, 0.0, 0.02 * i, kTilt);
    map.insert(noisy_frame(exact_frame(empty, pose), random), pose);
    for (const Voxel& v : map.voxels(Occupancy::kOccupied)) evident += v.z >= 0 && map.hit_frames(v) >= 3 ? 1u : 0u;
  }
  EXPECT_EQ(evident, 0u);
  EXPECT_EQ(above_floor(map), 0u);
  EXPECT_GT(map.counts().occupied, 2000u);
}

struct SmallThing {
  const char* name;
  TestScene scene;
};

std::vector<SmallThing> small_things(double x, double y) {
  const double floor = -0.012;
  std::vector<SmallThing> things{
      {"marker across", {}}, {"marker along", {}}, {"cube", {}}, {"ball", {}}, {"lemon", {}}};
  things[0].scene.boxes = {{{x, y, floor}, {x + 0.02, y + 0.12, floor + 0.02}}};
  things[1].scene.boxes = {{{x, y, floor}, {x + 0.12, y + 0.02, floor + 0.02}}};
  things[2].scene.boxes = {{{x, y, floor}, {x + 0.03, y + 0.03, floor + 0.03}}};
  things[3].scene.balls = {{{x, y, floor + 0.0325}, 0.0325}};
  things[4].scene.balls = {{{x, y, floor + 0.025}, 0.025}};
  return things;
}

TEST(VoxelMap, SmallThingsOnTheFloorAreFoundWhileDrivingTowardsThem) {
  RandomStream random(3, "things");
  for (int place = 0; place < 3; ++place) {
    const double x = 2.4 + random.uniform(0, 0.05), y = random.uniform(-0.3, 0.3);
    for (const SmallThing& thing : small_things(x, y)) {
      VoxelMap map;
      for (int i = 0; i < 12; ++i) {  // 0.3 m/s, 2.5 frames a second, from 2.4 m to 1 m
        const auto pose = camera_pose(0.12 * i, 0.0, 0.0, kTilt);
        map.insert(noisy_frame(exact_frame(thing.scene, pose), random), pose);
      }
      const Voxel at = map.voxel_at({x, y, 0.0});
      const Voxel low{at.x - 1, at.y - 1, 0}, high{at.x + 3, at.y + 3, 1};
      EXPECT_GE(occupied_in(map, low, high), 1u) << thing.name << " at " << x << ", " << y;
      EXPECT_EQ(above_floor(map), occupied_in(map, low, high)) << thing.name;
    }
  }
}

}  // namespace
}  // namespace amiss::mapping
