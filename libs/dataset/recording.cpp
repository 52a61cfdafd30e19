#include "dataset/recording.hpp"

#include "core/result.hpp"
#include "dataset/camera_file.hpp"
#include "dataset/internal/bag_file.hpp"
#include "dataset/internal/bag_recording.hpp"
#include "dataset/internal/folder_index.hpp"
#include "dataset/internal/images.hpp"

namespace amiss::dataset {
namespace {

namespace fs = std::filesystem;

constexpr double kMillimetres = 1000.0;

class FolderRecording : public Recording {
 public:
  FolderRecording(std::string format, FolderIndex index, CameraFile camera)
      : format_(std::move(format)), index_(std::move(index)), camera_(camera) {}

  [[nodiscard]] std::string format() const override { return format_; }
  [[nodiscard]] std::size_t size() const override { return index_.frames.size(); }
  [[nodiscard]] std::size_t dropped() const override { return index_.dropped; }
  [[nodiscard]] PosedFrame load(std::size_t i) const override {
    const IndexedFrame& f = index_.frames.at(i);
    return {frame_of(load_colour(f.colour), load_depth(f.depth, camera_.depth_scale), camera_.intrinsics, f.stamp,
                     f.depth.string()),
            f.T_map_camera};
  }

 private:
  std::string format_;
  FolderIndex index_;
  CameraFile camera_;
};

CameraFile camera_of(const fs::path& folder, const FolderIndex& index, double usual_scale,
                     const RecordingOptions& options) {
  CameraFile camera;
  camera.depth_scale = usual_scale;
  if (fs::exists(folder / "camera.yaml")) {
    camera = load_camera(folder / "camera.yaml");
  } else if (!options.intrinsics) {
    throw InputError(folder.string() +
                     ": does not say what the camera is; a file camera.yaml with camera.fx, fy, cx, cy, width, height "
                     "and depth_scale, or --intrinsics FX,FY,CX,CY is needed");
  }
  if (options.depth_scale) camera.depth_scale = *options.depth_scale;
  if (options.intrinsics) {
    camera.intrinsics = *options.intrinsics;
    const DepthImage first = load_depth(index.frames.front().depth, camera.depth_scale);
    camera.intrinsics.width = first.width;
    camera.intrinsics.height = first.height;
  }
  return camera;
}

std::unique_ptr<Recording> open_folder(const fs::path& folder, const RecordingOptions& options) {
  std::string format;
  FolderIndex index;
  double usual_scale = kMillimetres;
  if (is_tum_folder(folder)) {
    format = "TUM RGB-D folder";
    index = index_tum(folder, options.poses);
    usual_scale = kTumDepthScale;
  } else if (is_open3d_folder(folder)) {
    format = "Open3D folder";
    index = index_open3d(folder);
  } else if (is_7scenes_folder(folder)) {
    format = "7-Scenes folder";
    index = index_7scenes(folder);
  } else {
    throw InputError(folder.string() +
                     ": is no recording that is known; a TUM RGB-D folder (rgb.txt, depth.txt, groundtruth.txt), a "
                     "7-Scenes folder (frame-N.pose.txt) or an Open3D folder (trajectory.log) is needed");
  }
  if (index.frames.empty()) {
    throw InputError(folder.string() + ": has no frame with colour, depth and a pose (" +
                     std::to_string(index.dropped) + " lack one of them)");
  }
  const CameraFile camera = camera_of(folder, index, usual_scale, options);
  return std::make_unique<FolderRecording>(std::move(format), std::move(index), camera);
}

}  // namespace

std::unique_ptr<Recording> open_recording(const fs::path& path, const RecordingOptions& options) {
  if (!fs::exists(path)) throw InputError(path.string() + ": there is no such file or folder");
  if (!options.poses.empty() && !is_tum_folder(path)) {
    throw ArgumentError(path.string() + ": other poses than its own are taken for TUM RGB-D folders and rawlogs only");
  }
  if (!fs::is_directory(path)) {
    if (BagFile::is_bag(path)) return open_bag(path, options);
    throw InputError(path.string() +
                     ": is no recording that is known; a ROS 1 bag, an MRPT rawlog or a folder is needed");
  }
  return open_folder(path, options);
}

}  // namespace amiss::dataset
