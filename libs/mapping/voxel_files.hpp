// OctoMap's files: .ot (log-odds) and .bt (free and occupied only), read with distrust and written whole or not at all.
//
// in: file     out: VoxelMap with the file's resolution, or InputError that names the file and what is wrong: header
// incomplete, another tree than OcTree, resolution outside 0.001 .. 10 m, cut short, bytes left over, more or fewer
// nodes than announced, values that are not finite, inner nodes that are not the maximum of their children, space
// beyond max_blocks. Files of older formats are refused.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

/// `params` gives all but the resolution. The extension does not matter: the first line says which format it is.
[[nodiscard]] VoxelMap load_voxel_map(const std::filesystem::path& file, const VoxelMapParams& params = {});
/// The same from bytes; `name` stands in the errors.
[[nodiscard]] VoxelMap parse_voxel_map(std::string_view bytes, const std::string& name,
                                       const VoxelMapParams& params = {});

/// .ot or .bt by the extension; ArgumentError for another one, std::runtime_error when writing fails.
void save_voxel_map(const std::filesystem::path& file, const VoxelMap& map);
enum class VoxelFormat { kOt, kBt };
[[nodiscard]] std::string voxel_map_bytes(const VoxelMap& map, VoxelFormat format);

}  // namespace amiss::mapping
