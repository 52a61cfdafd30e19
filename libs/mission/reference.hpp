// The reference: what the robot knows of a place from its one-time mapping run (thesis 4.2.1).
// A folder with map.yaml + map.pgm (map_server), mapped.ot (as mapped, spurious voxels taken out) and reference.ot (the
// same dilated). The map frame is where the robot stood when that run began. InputError when something is missing.
#pragma once

#include <filesystem>

#include "core/floor_grid.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::mission {

struct Reference {
  FloorGrid floor;              // from the laser
  mapping::VoxelMap mapped;     // what stands there
  mapping::VoxelMap reference;  // dilated, to compare with
};

[[nodiscard]] Reference load_reference(const std::filesystem::path& folder, const mapping::VoxelMapParams& params);
void save_reference(const std::filesystem::path& folder, const Reference& reference);

}  // namespace amiss::mission
