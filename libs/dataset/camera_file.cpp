#include "dataset/camera_file.hpp"

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::dataset {

void describe(ParamTable& table, CameraFile& camera) {
  table.integer("camera.width", camera.intrinsics.width, 1, 8192, "columns of the images");
  table.integer("camera.height", camera.intrinsics.height, 1, 8192, "rows of the images");
  table.number("camera.fx", camera.intrinsics.fx, "pixels", 1.0, 1e5, "focal length along the rows");
  table.number("camera.fy", camera.intrinsics.fy, "pixels", 1.0, 1e5, "focal length along the columns");
  table.number("camera.cx", camera.intrinsics.cx, "pixels", -1e4, 1e5, "principal point, column");
  table.number("camera.cy", camera.intrinsics.cy, "pixels", -1e4, 1e5, "principal point, row");
  table.number("camera.depth_scale", camera.depth_scale, "1/m", 1.0, 1e6, "units of a depth image for a metre");
}

CameraFile load_camera(const std::filesystem::path& file) {
  CameraFile camera;
  ParamTable table;
  describe(table, camera);
  try {
    table.load_file(file);
  } catch (const ArgumentError& e) {
    throw InputError(e.what());  // a file of the recording, nothing that was set on the command line
  }
  return camera;
}

void save_camera(const std::filesystem::path& file, CameraFile camera) {
  ParamTable table;
  describe(table, camera);
  save_atomically(file, table.to_yaml());
}

}  // namespace amiss::dataset
