// camera.yaml: what a folder of images was taken with.
//   camera: {width: 640, height: 480, fx: 525, fy: 525, cx: 319.5, cy: 239.5, depth_scale: 1000}
// depth_scale: units of a 16-bit depth image for a metre. Images are rectified. Errors: InputError, in the words of
// ParamTable.
#pragma once

#include <filesystem>

#include "core/params.hpp"
#include "core/sensors.hpp"

namespace amiss::dataset {

inline constexpr double kTumDepthScale = 5000.0;  // 1/m, what TUM RGB-D folders have

struct CameraFile {
  CameraIntrinsics intrinsics;
  double depth_scale = 1000.0;
};
void describe(ParamTable& table, CameraFile& camera);

[[nodiscard]] CameraFile load_camera(const std::filesystem::path& file);
void save_camera(const std::filesystem::path& file, CameraFile camera);

}  // namespace amiss::dataset
