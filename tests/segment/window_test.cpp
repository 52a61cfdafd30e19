#include "segment/internal/window.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "segment/scene.hpp"

namespace amiss::segment::internal {
namespace {

/// Every pixel of the whole frame, one by one.
std::vector<std::uint32_t> inside_slowly(const testing::View& view, const Cylinder& crop, double max_range_m) {
  std::vector<std::uint32_t> inside;
  const CameraIntrinsics& k = view.frame.intrinsics;
  for (std::uint32_t i = 0; i < view.frame.depth_m.size(); ++i) {
    const auto z = static_cast<double>(view.frame.depth_m[i]);
    if (!(z <= max_range_m)) continue;
    const Eigen::Vector3d p =
        view.T_map_camera.T * Eigen::Vector3d((i % 640 - k.cx) / k.fx * z, (i / 640 - k.cy) / k.fy * z, z);
    if ((p.head<2>() - crop.centre_map).norm() <= crop.radius_m && p.z() >= crop.z_low_m && p.z() <= crop.z_high_m) {
      inside.push_back(i);
    }
  }
  return inside;
}

RC_GTEST_PROP(Window, HoldsEveryPixelOfTheCrop, ()) {
  static const testing::View view =
      testing::look({testing::box_at(1.2, 0.1, {0.3, 0.2, 0.3}, 0.3, {9, 9, 9})}, -0.7, 1);
  const auto between = [](int low, int high) { return *rc::gen::inRange(low, high + 1) / 100.0; };
  const Cylinder crop{{between(20, 300), between(-120, 120)}, between(5, 60), between(-20, 0), between(1, 60)};
  const Window window = window_of(view.frame, view.T_map_camera, crop, 3.5);
  std::vector<std::uint32_t> inside;
  for (std::size_t i = 0; i < window.where.size(); ++i) {
    if (window.where[i] == Where::kInside) inside.push_back(window.pixel_of(i));
  }
  const auto slowly = inside_slowly(view, crop, 3.5);
  // float against double: a few pixels on the very border may differ
  RC_ASSERT(std::abs(static_cast<double>(inside.size()) - static_cast<double>(slowly.size())) <=
            3.0 + 0.001 * static_cast<double>(slowly.size()));
}

TEST(Window, SmoothingHalvesTheNoise) {
  const testing::View view = testing::look({}, -0.75, 3);
  const Window window = window_of(view.frame, view.T_map_camera, {{0.95, 0.0}, 0.3, -0.2, 0.3}, 3.5);
  double raw = 0.0, smooth = 0.0;
  for (std::size_t i = 0; i < window.where.size(); ++i) {
    if (window.where[i] != Where::kInside) continue;
    raw += std::pow(static_cast<double>(window.points[i].z()) - testing::kFloorZ, 2);
    smooth += std::pow(static_cast<double>(window.smooth[i].z()) - testing::kFloorZ, 2);
  }
  EXPECT_GT(raw, 0.0);
  EXPECT_LT(smooth, raw / 4.0);
}

}  // namespace
}  // namespace amiss::segment::internal
