#include "change/difference.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "core/random.hpp"
#include "core/result.hpp"
#include "mapping/voxel_files.hpp"

namespace amiss::change {
namespace {

using mapping::Voxel;
using mapping::VoxelMap;

Voxel random_voxel(RandomStream& random) {
  const auto index = [&random](int n) { return static_cast<int>(random.below(static_cast<std::uint64_t>(n))); };
  return {index(40) - 20, index(40) - 20, index(12) - 2};
}

void scatter(VoxelMap& map, RandomStream& random, int n, bool forget) {
  for (int i = 0; i < n; ++i) {
    const Occupancy value = random.below(4) == 0 ? Occupancy::kOccupied : Occupancy::kFree;
    map.set(random_voxel(random), forget && random.below(10) == 0 ? Occupancy::kUnknown : value);
  }
}

FloorGrid random_grid(RandomStream& random) {
  FloorGrid grid(0.07, {-0.8, -0.9}, 25, 24, Occupancy::kFree);
  for (int i = 0; i < 30; ++i) {
    const Cell c{static_cast<int>(random.below(25)), static_cast<int>(random.below(24))};
    grid.set(c, random.below(2) == 0 ? Occupancy::kOccupied : Occupancy::kUnknown);
  }
  return grid;
}

RC_GTEST_PROP(Difference, WhatChangedGivesTheSameAsEverything, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 10000)), "difference");
  DifferenceParams params;
  params.reference_dilation_voxels = *rc::gen::inRange(0, 3);
  params.grid_dilation_cells = *rc::gen::inRange(0, 3);
  VoxelMap reference, current;
  scatter(reference, random, 8000, false);
  reference = dilated(reference, params.reference_dilation_voxels > 0 && random.below(2) == 0 ? 1 : 0);
  std::optional<FloorGrid> grid;
  if (*rc::gen::arbitrary<bool>()) grid = random_grid(random);
  Differencer differencer(reference, grid, params);
  RC_ASSERT(differencer.latest() == difference(reference, VoxelMap{}, grid, params));
  for (int round = 0; round < 4; ++round) {
    scatter(current, random, round == 2 ? 3 : 3000, true);
    RC_ASSERT(differencer.update(current) == difference(reference, current, grid, params));
  }
  VoxelMap other;
  other.set({0, 0, 0}, Occupancy::kOccupied);
  RC_ASSERT(differencer.update(other) == difference(reference, other, grid, params));
}

TEST(Difference, OnlyKnownFreeSpaceCanShowSomethingNew) {
  VoxelMap reference, current;
  reference.set({0, 0, 0}, Occupancy::kFree);
  reference.set({1, 0, 0}, Occupancy::kOccupied);
  for (int x = 0; x < 3; ++x) current.set({x, 0, 0}, Occupancy::kOccupied);
  DifferenceParams params;
  params.reference_dilation_voxels = 0;
  EXPECT_EQ(difference(reference, current, std::nullopt, params).appeared, (std::vector<Voxel>{{0, 0, 0}}));
}

TEST(Difference, TheGridDropsItsObstaclesAndWhatLiesOutside) {
  VoxelMap reference, current;
  for (int x = -10; x < 10; ++x) {
    reference.set({x, 2, 0}, Occupancy::kFree);
    current.set({x, 2, 0}, Occupancy::kOccupied);
  }
  FloorGrid grid(0.05, {-0.25, 0.0}, 12, 6, Occupancy::kFree);  // voxels -5 .. 6
  grid.set({0, 2}, Occupancy::kOccupied);                       // with two cells around: voxels -5 .. -3
  grid.set({11, 2}, Occupancy::kUnknown);                       // voxel 6
  Differencer differencer(reference, grid);
  const std::vector<Voxel>& appeared = differencer.update(current).appeared;
  ASSERT_EQ(appeared.size(), 8u);
  EXPECT_EQ(appeared.front(), (Voxel{-2, 2, 0}));
  EXPECT_EQ(appeared.back(), (Voxel{5, 2, 0}));
}

TEST(Difference, ATableThatIsGoneHasVanishedAndASmallShiftHasNot) {
  VoxelMap scene;
  for (int i = 0; i < 400; ++i) scene.set({i % 20, i / 20, 4}, Occupancy::kFree);
  VoxelMap was = scene, gone = scene, shifted = scene;
  for (int y = 8; y < 12; ++y) {
    was.set({8, y, 4}, Occupancy::kOccupied);
    shifted.set({9, y, 4}, Occupancy::kOccupied);
  }
  Differencer differencer(dilated(was, 1), std::nullopt);
  EXPECT_EQ(differencer.update(gone).vanished, was.voxels(Occupancy::kOccupied));
  Differencer again(dilated(was, 1), std::nullopt);
  EXPECT_TRUE(again.update(shifted).vanished.empty());
  EXPECT_TRUE(again.latest().appeared.empty());
}

TEST(Difference, UnseenIsWhatOnlyTheReferenceKnows) {
  VoxelMap reference, current;
  for (int x = 0; x < 30; ++x) reference.set({x, 0, 0}, Occupancy::kFree);
  Differencer differencer(reference, std::nullopt);
  EXPECT_EQ(differencer.latest().unseen, 30u);
  for (int x = 0; x < 10; ++x) current.set({x, 0, 0}, Occupancy::kFree);
  current.set({100, 0, 0}, Occupancy::kFree);
  EXPECT_EQ(differencer.update(current).unseen, 20u);
}

TEST(Difference, RefusesAnotherResolution) {
  mapping::VoxelMapParams params;
  params.resolution_m = 0.1;
  Differencer differencer(VoxelMap{}, std::nullopt);
  EXPECT_THROW((void)differencer.update(VoxelMap{params}), ArgumentError);
  EXPECT_THROW((void)difference(VoxelMap{}, VoxelMap{params}, std::nullopt), ArgumentError);
}

TEST(Difference, OfOctoMapsOwnMap) {
  const char* elsewhere = std::getenv("AMISS_TEST_DATA");
  const std::filesystem::path data = elsewhere != nullptr
                                         ? std::filesystem::path(elsewhere)
                                         : std::filesystem::path(AMISS_SOURCE_DIR).parent_path() / "shared" / "data";
  const std::filesystem::path file = data / "octomap" / "geb079.bt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const VoxelMap reference = mapping::load_voxel_map(file);
  DifferenceParams params;
  params.reference_dilation_voxels = 0;
  Differencer differencer(reference, std::nullopt, params);
  EXPECT_EQ(differencer.update(reference), Difference{});
  // A block of free voxels becomes occupied, a block of occupied ones free.
  VoxelMap current = reference;
  std::vector<Voxel> added = reference.voxels(Occupancy::kFree), removed = reference.voxels(Occupancy::kOccupied);
  const auto keep_block = [](std::vector<Voxel>& voxels) {
    const Voxel middle = voxels[voxels.size() / 2];
    std::erase_if(voxels, [&](const Voxel& v) {
      return std::abs(v.x - middle.x) > 3 || std::abs(v.y - middle.y) > 3 || std::abs(v.z - middle.z) > 3;
    });
  };
  keep_block(added);
  for (const Voxel& v : added) current.set(v, Occupancy::kOccupied);
  EXPECT_EQ(differencer.update(current).appeared, added);
  EXPECT_TRUE(differencer.latest().vanished.empty());
  for (const Voxel& v : added) current.set(v, Occupancy::kFree);
  EXPECT_EQ(differencer.update(current), Difference{});
  keep_block(removed);
  for (const Voxel& v : reference.voxels(Occupancy::kOccupied)) {
    const bool inside = std::find(removed.begin(), removed.end(), v) != removed.end();
    if (inside) current.set(v, Occupancy::kFree);
  }
  EXPECT_EQ(differencer.update(current), difference(reference, current, std::nullopt, params));
  EXPECT_FALSE(differencer.latest().vanished.empty());
}

}  // namespace
}  // namespace amiss::change
