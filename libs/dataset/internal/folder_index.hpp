// Which images and poses of a folder belong together; one function for each layout of recording.hpp.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "dataset/trajectory_files.hpp"

namespace amiss::dataset {

struct IndexedFrame {
  Stamp stamp;
  std::filesystem::path colour, depth;
  Transform<Map, Camera> T_map_camera;
};
struct FolderIndex {
  std::vector<IndexedFrame> frames;
  std::size_t dropped = 0;
};

[[nodiscard]] bool is_tum_folder(const std::filesystem::path& folder);
[[nodiscard]] FolderIndex index_tum(const std::filesystem::path& folder, const std::filesystem::path& poses = {});
[[nodiscard]] bool is_7scenes_folder(const std::filesystem::path& folder);
[[nodiscard]] FolderIndex index_7scenes(const std::filesystem::path& folder);
[[nodiscard]] bool is_open3d_folder(const std::filesystem::path& folder);
[[nodiscard]] FolderIndex index_open3d(const std::filesystem::path& folder);

/// For each colour image the nearest depth image within 0.02 s, as pairs of indices; each is used once, as in TUM's
/// associate.py. Both lists are sorted.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> associated(const std::vector<Stamp>& colour,
                                                                          const std::vector<Stamp>& depth);

}  // namespace amiss::dataset
