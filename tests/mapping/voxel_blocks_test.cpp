#include "mapping/voxel_blocks.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "core/random.hpp"

namespace amiss::mapping {
namespace {

RC_GTEST_PROP(VoxelBlocks, FindsWhatWasAddedInItsSlot, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 10000)), "blocks");
  VoxelBlocks blocks;
  std::map<BlockKey, std::uint32_t> slots;
  for (int i = 0; i < 500; ++i) {
    const auto index = [&random] { return static_cast<int>(random.below(30)) - 15; };
    const BlockKey key{index() * 100, index(), index() / 5};
    const std::uint32_t slot = blocks.find_or_add(key);
    RC_ASSERT(slots.try_emplace(key, slot).first->second == slot);
  }
  RC_ASSERT(blocks.blocks().size() == slots.size());
  for (const auto& [key, slot] : slots) RC_ASSERT(blocks.find(key) == slot && blocks.blocks()[slot].key == key);
  RC_ASSERT(blocks.find({99, 99, 99}) == VoxelBlocks::kNone);
}

TEST(VoxelBlocks, NegativeVoxelsLieInNegativeBlocks) {
  EXPECT_EQ(block_of({-1, -8, -9}), (BlockKey{-1, -1, -2}));
  for (const Voxel v : {Voxel{-1, -8, -9}, Voxel{0, 7, 8}, Voxel{-kVoxelLimit, kVoxelLimit - 1, 3}}) {
    EXPECT_EQ(voxel_in(block_of(v), v.z & 7, static_cast<int>(bit_in_layer(v))), v);
    EXPECT_TRUE(in_limits(v));
  }
  EXPECT_FALSE(in_limits({kVoxelLimit, 0, 0}));
}

}  // namespace
}  // namespace amiss::mapping
