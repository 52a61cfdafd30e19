#include "reconstruct_recording.hpp"

#include "recording/rawlog_frames.hpp"

namespace amiss::app {

std::unique_ptr<dataset::Recording> open_any_recording(const std::filesystem::path& path,
                                                       const dataset::RecordingOptions& options) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error) && recording::is_rawlog(path)) {
    return recording::open_rawlog(path, options);
  }
  return dataset::open_recording(path, options);
}

std::optional<CameraIntrinsics> intrinsics_of(const std::vector<double>& given) {
  if (given.empty()) return {};
  CameraIntrinsics camera;
  camera.fx = given.at(0);
  camera.fy = given.at(1);
  camera.cx = given.at(2);
  camera.cy = given.at(3);
  return camera;
}

}  // namespace amiss::app
