// Folders of numbered frames: 7-Scenes and Open3D.
#include <algorithm>
#include <map>

#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/internal/folder_index.hpp"

namespace amiss::dataset {
namespace {

namespace fs = std::filesystem;

constexpr Duration kFramePeriod = std::chrono::microseconds(33'333);  // of a Kinect; the layouts have no times

std::vector<fs::path> sorted_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool is_image(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

std::map<std::string, fs::path> images_by_number(const fs::path& folder) {
  std::map<std::string, fs::path> images;
  for (const fs::path& file : sorted_files(folder)) {
    if (is_image(file)) images.emplace(file.stem().string(), file);
  }
  return images;
}

fs::path colour_folder(const fs::path& folder) {
  return fs::is_directory(folder / "color") ? folder / "color" : folder / "image";
}

}  // namespace

bool is_7scenes_folder(const fs::path& folder) {
  const std::vector<fs::path> files = sorted_files(folder);
  return std::any_of(files.begin(), files.end(),
                     [](const fs::path& file) { return file.filename().string().ends_with(".pose.txt"); });
}

FolderIndex index_7scenes(const fs::path& folder) {
  FolderIndex index;
  std::size_t colour_images = 0, number = 0;
  for (const fs::path& file : sorted_files(folder)) {
    const std::string stem = file.stem().string();
    if (!is_image(file) || !stem.ends_with(".color")) continue;
    ++colour_images;
    const std::string frame = stem.substr(0, stem.size() - 6);
    const fs::path pose = folder / (frame + ".pose.txt"), depth = folder / (frame + ".depth.png");
    if (!fs::exists(pose) || !fs::exists(depth)) continue;
    const Stamp stamp(kFramePeriod * static_cast<std::int64_t>(number++));
    index.frames.push_back({stamp, file, depth, parse_pose_matrix(load_bytes(pose), pose.string())});
  }
  index.dropped = colour_images - index.frames.size();
  return index;
}

bool is_open3d_folder(const fs::path& folder) {
  return fs::exists(folder / "trajectory.log") && fs::is_directory(folder / "depth") &&
         fs::is_directory(colour_folder(folder));
}

FolderIndex index_open3d(const fs::path& folder) {
  const fs::path log = folder / "trajectory.log";
  const auto poses = parse_open3d_log(load_bytes(log), log.string());
  const auto colour = images_by_number(colour_folder(folder)), depth = images_by_number(folder / "depth");
  FolderIndex index;
  std::size_t k = 0;
  for (const auto& [number, file] : depth) {
    const auto partner = colour.find(number);
    if (partner != colour.end() && k < poses.size()) {
      index.frames.push_back({Stamp(kFramePeriod * static_cast<std::int64_t>(k)), partner->second, file, poses[k]});
    } else {
      ++index.dropped;
    }
    ++k;
  }
  return index;
}

}  // namespace amiss::dataset
