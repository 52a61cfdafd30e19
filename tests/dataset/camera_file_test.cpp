#include "dataset/camera_file.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::dataset {
namespace {

TEST(CameraFile, RoundTripAndUnknownKeys) {
  const test::TemporaryFolder folder;
  CameraFile camera;
  camera.intrinsics = {320, 240, 262.5, 263.25, 159.5, 119.5};
  camera.depth_scale = 5000;
  save_camera(folder.path() / "camera.yaml", camera);
  const CameraFile again = load_camera(folder.path() / "camera.yaml");
  EXPECT_EQ(again.intrinsics, camera.intrinsics);
  EXPECT_EQ(again.depth_scale, 5000.0);
  EXPECT_THROW((void)load_camera(folder.write("odd.yaml", "camera: {k1: 0.3}\n")), InputError);
  EXPECT_THROW((void)load_camera(folder.write("flat.yaml", "camera: {fx: 0}\n")), InputError);
}

}  // namespace
}  // namespace amiss::dataset
