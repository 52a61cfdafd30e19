// libFuzzer target: any bytes as an OctoMap file end with a map or an InputError, never with a crash; what was read is
// written and read again as the same.
#include <cstdint>
#include <string_view>

#include "core/result.hpp"
#include "mapping/voxel_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amiss::mapping;
  try {
    const VoxelMap map = parse_voxel_map({reinterpret_cast<const char*>(data), size}, "fuzz");
    if (map.values().blocks().size() > 64) return 0;
    const VoxelMap again = parse_voxel_map(voxel_map_bytes(map, VoxelFormat::kOt), "again");
    if (again.counts() != map.counts()) __builtin_trap();
  } catch (const amiss::InputError&) {  // what bad input should end with
  }
  return 0;
}
