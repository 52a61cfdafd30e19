#include "mapping/seen_space.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"
#include "core/result.hpp"

namespace amiss::mapping {
namespace {

VoxelMap random_map(RandomStream& random) {
  VoxelMap map;
  for (int i = 0; i < 3000; ++i) {
    const auto at = [&] { return static_cast<int>(random.below(20)) - 10; };
    map.set({at(), at(), at()}, random.below(10) == 0 ? Occupancy::kOccupied : Occupancy::kFree);
  }
  return map;
}

RC_GTEST_PROP(SeenSpace, IsFreeWhereAllIsFreeAndOccupiedWhereAnythingIs, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 10000)), "space");
  const VoxelMap map = random_map(random);
  const int factor = *rc::gen::element(1, 2, 4, 8);
  const VoxelMap space = seen_space(map.values(), 0.01, factor);
  RC_ASSERT(std::abs(space.resolution_m() - 0.01 * factor) < 1e-12);
  const int reach = 16 / factor;
  for (int x = -reach; x < reach; ++x) {
    for (int y = -reach; y < reach; ++y) {
      for (int z = -reach; z < reach; ++z) {
        int free = 0, occupied = 0;
        for (int i = 0; i < factor * factor * factor; ++i) {
          const Voxel v{x * factor + i % factor, y * factor + i / factor % factor, z * factor + i / factor / factor};
          free += map.at(v) == Occupancy::kFree ? 1 : 0;
          occupied += map.at(v) == Occupancy::kOccupied ? 1 : 0;
        }
        const Occupancy expected = occupied > 0                       ? Occupancy::kOccupied
                                   : free == factor * factor * factor ? Occupancy::kFree
                                                                      : Occupancy::kUnknown;
        RC_ASSERT(space.at(Voxel{x, y, z}) == expected);
      }
    }
  }
}

TEST(SeenSpace, RefusesOtherFactors) {
  for (const int factor : {-1, 0, 3, 16}) {
    EXPECT_THROW((void)seen_space(VoxelMap().values(), 0.01, factor), ArgumentError) << factor;
  }
}

}  // namespace
}  // namespace amiss::mapping
