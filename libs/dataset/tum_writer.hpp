// Writes a recording as a TUM RGB-D folder: rgb/*.png, depth/*.png (16 bits), rgb.txt, depth.txt, groundtruth.txt (the
// poses that the recording holds, estimated or true) and camera.yaml. Images are written as frames come, the lists at
// the end: a folder without lists is no recording. Times must grow. std::runtime_error when writing fails.
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
  void add(const PosedFrame& frame);
  void finish() const;

 private:
  std::filesystem::path folder_;
  CameraFile camera_;
  std::vector<StampedPose> poses_;
  std::string colour_list_, depth_list_;
};

}  // namespace amiss::dataset
