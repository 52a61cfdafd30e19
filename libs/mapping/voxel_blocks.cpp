#include "mapping/voxel_blocks.hpp"

namespace amiss::mapping {
namespace {

std::size_t hash_of(BlockKey key) {
  const auto bits = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)); };
  std::uint64_t h = bits(key.x) * 0x9E3779B97F4A7C15u;
  h ^= bits(key.y) * 0xC2B2AE3D27D4EB4Fu;
  h ^= bits(key.z) * 0x165667B19E3779F9u;
  return static_cast<std::size_t>(h ^ (h >> 32));
}

}  // namespace

std::uint32_t VoxelBlocks::find(BlockKey key) const {
  if (table_.empty()) return kNone;
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = hash_of(key) & mask;; i = (i + 1) & mask) {
    if (table_[i] == kNone || blocks_[table_[i]].key == key) return table_[i];
  }
}

std::uint32_t VoxelBlocks::find_or_add(BlockKey key) {
  const std::uint32_t found = find(key);
  if (found != kNone) return found;
  if (2 * (blocks_.size() + 1) > table_.size()) grow();
  const std::size_t mask = table_.size() - 1;
  std::size_t i = hash_of(key) & mask;
  while (table_[i] != kNone) i = (i + 1) & mask;
  table_[i] = static_cast<std::uint32_t>(blocks_.size());
  blocks_.emplace_back().key = key;
  return table_[i];
}

void VoxelBlocks::grow() {
  table_.assign(table_.empty() ? 64 : 2 * table_.size(), kNone);
  const std::size_t mask = table_.size() - 1;
  for (std::uint32_t slot = 0; slot < blocks_.size(); ++slot) {
    std::size_t i = hash_of(blocks_[slot].key) & mask;
    while (table_[i] != kNone) i = (i + 1) & mask;
    table_[i] = slot;
  }
}

}  // namespace amiss::mapping
