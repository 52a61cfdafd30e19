#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "core/random.hpp"
#include "mapping/plane_ops.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::mapping {
namespace {

VoxelMap random_map(std::uint64_t seed) {
  VoxelMap map;
  RandomStream random(seed, "edits");
  for (int i = 0; i < 400; ++i) {
    const auto index = [&random] { return static_cast<int>(random.below(24)) - 12; };
    map.set({index(), index(), index() / 4}, random.below(3) == 0 ? Occupancy::kOccupied : Occupancy::kFree);
  }
  return map;
}

RC_GTEST_PROP(VoxelMapEdits, DilationGrowsEveryOccupiedVoxelInXAndY, ()) {
  const VoxelMap map = random_map(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000)));
  const int radius = *rc::gen::inRange(0, 4);
  const VoxelMap grown_map = dilated(map, radius);
  std::set<Voxel> expected;
  for (const Voxel& v : map.voxels(Occupancy::kOccupied)) {
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) expected.insert({v.x + dx, v.y + dy, v.z});
    }
  }
  RC_ASSERT(grown_map.voxels(Occupancy::kOccupied) == std::vector<Voxel>(expected.begin(), expected.end()));
  for (const Voxel& v : map.voxels(Occupancy::kFree))
    RC_ASSERT(grown_map.at(v) == (expected.contains(v) ? Occupancy::kOccupied : Occupancy::kFree));
}

TEST(VoxelMapEdits, SpecklesBecomeFreeAndGroupsStay) {
  VoxelMap map;
  map.set({0, 0, 10}, Occupancy::kOccupied);
  map.set({5, 5, 5}, Occupancy::kOccupied);
  map.set({6, 6, 6}, Occupancy::kOccupied);
  const VoxelMap cleaned = without_speckles(map);
  EXPECT_EQ(cleaned.at(Voxel{0, 0, 10}), Occupancy::kFree);
  EXPECT_EQ(cleaned.counts().occupied, 2u);
  EXPECT_EQ(without_speckles(map, 2).counts().occupied, 0u);
  EXPECT_EQ(without_speckles(map, 0).counts().occupied, 3u);
}

TEST(VoxelMapEdits, TheFloorHoldsNoSpeckleAndIsNone) {
  VoxelMap map;
  map.set({0, 0, -1}, Occupancy::kOccupied);
  map.set({0, 0, 0}, Occupancy::kOccupied);
  const VoxelMap cleaned = without_speckles(map);
  EXPECT_EQ(cleaned.at(Voxel{0, 0, -1}), Occupancy::kOccupied);
  EXPECT_EQ(cleaned.at(Voxel{0, 0, 0}), Occupancy::kFree);
}

TEST(PlaneOps, ShrinkingTakesGrowingBackFromASquare) {
  VoxelBlocks blocks;
  blocks.at_slot(blocks.find_or_add({0, 0, 0})).occupied[3] = std::uint64_t{1} << 27;
  const std::uint64_t square = grown(occupied_around(blocks, {0, 0, 0}, 3));
  EXPECT_EQ(std::popcount(square), 9);
  Neighbourhood n{};
  n[1][1] = square;
  EXPECT_EQ(shrunk(n), std::uint64_t{1} << 27);
}

}  // namespace
}  // namespace amiss::mapping
