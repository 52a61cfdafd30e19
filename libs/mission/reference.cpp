#include "mission/reference.hpp"

#include "mapping/floor_grid_files.hpp"
#include "mapping/voxel_files.hpp"

namespace amiss::mission {

Reference load_reference(const std::filesystem::path& folder, const mapping::VoxelMapParams& params) {
  return {mapping::load_floor_grid(folder / "map.yaml"), mapping::load_voxel_map(folder / "mapped.ot", params),
          mapping::load_voxel_map(folder / "reference.ot", params)};
}

void save_reference(const std::filesystem::path& folder, const Reference& reference) {
  mapping::save_floor_grid(folder / "map.yaml", reference.floor);
  mapping::save_voxel_map(folder / "mapped.ot", reference.mapped);
  mapping::save_voxel_map(folder / "reference.ot", reference.reference);
}

}  // namespace amiss::mission
