#include "fuzz/seeds.hpp"
#include "mapping/voxel_files.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() {
  mapping::VoxelMap map;
  for (int x = -9; x < 9; ++x) {
    for (int y = -3; y < 12; ++y) map.set({x, y, 0}, (x * y) % 5 == 0 ? Occupancy::kOccupied : Occupancy::kFree);
  }
  return {voxel_map_bytes(map, mapping::VoxelFormat::kOt), voxel_map_bytes(map, mapping::VoxelFormat::kBt)};
}

std::vector<std::string> words() {
  return {"# Octomap OcTree file\n",
          "# Octomap OcTree binary file\n",
          "id ColorOcTree\n",
          "size 1\n",
          "res 1e-9\n",
          "data\n",
          "\x7f\xc0"};
}

}  // namespace amiss::fuzz
