// Writes a recording as a TUM RGB-D folder: rgb/*.png, depth/*.png (16 bits), rgb.txt, depth.txt, camera.yaml and
// the poses: groundtruth.txt where a frame has one pose; where it has two, groundtruth.txt holds the true
// ones and estimated.txt those that the robot believed in, which open_recording() takes. Images are written as frames
// come, the lists at the end: a folder without lists is no recording. Times must grow. std::runtime_error when writing
// fails.
#pragma once

#include <filesystem>

#include "dataset/camera_file.hpp"
#include "dataset/recording.hpp"
#include "dataset/trajectory_files.hpp"

namespace amiss::dataset {

class TumWriter {
 public:
  /// The folder must be new or empty: ArgumentError.
  TumWriter(std::filesystem::path folder, const CameraFile& camera);
  /// With `T_map_camera_true` the frame's own pose is an estimate; all frames of a recording have one, or none.
  void add(const PosedFrame& frame, const std::optional<Transform<Map, Camera>>& T_map_camera_true = {});
  void finish() const;
  /// associations.txt: colour and depth as pairs, which other programs ask for.
  void save_associations() const;

 private:
  std::filesystem::path folder_;
  CameraFile camera_;
  std::vector<StampedPose> poses_, true_poses_;
  std::string colour_list_, depth_list_, pairs_;
};

}  // namespace amiss::dataset
