// The part of a frame that holds a crop: organized points in the map frame, raw and smoothed.
#pragma once

#include <vector>

#include "segment/segment.hpp"

namespace amiss::segment::internal {

enum class Where : std::uint8_t {
  kNothing,  // no depth, or too far
  kOutside,  // of the crop
  kInside
};

/// Row-major, `width` x `height` pixels from (u0, v0) of the frame on.
struct Window {
  int u0 = 0, v0 = 0, width = 0, height = 0;
  int frame_width = 0, frame_height = 0;
  Eigen::Vector3f camera_map = Eigen::Vector3f::Zero();
  std::vector<Where> where;
  std::vector<Eigen::Vector3f> points;  // map
  std::vector<Eigen::Vector3f> smooth;  // map, depth averaged over 3x3 pixels of the same surface
  std::vector<Rgb> colours;
  std::vector<float> range_m;  // depth along z of the camera

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] std::uint32_t pixel_of(std::size_t i) const {
    const auto w = static_cast<std::size_t>(width);
    const std::size_t v = static_cast<std::size_t>(v0) + i / w, u = static_cast<std::size_t>(u0) + i % w;
    return static_cast<std::uint32_t>(v * static_cast<std::size_t>(frame_width) + u);
  }
  [[nodiscard]] bool at_image_border(std::size_t i) const {
    const int u = u0 + static_cast<int>(i) % width, v = v0 + static_cast<int>(i) / width;
    return u == 0 || v == 0 || u == frame_width - 1 || v == frame_height - 1;
  }
};

/// What lies inside the upright cylinder, or below its top where `radius_m` is infinite.
[[nodiscard]] Window window_of(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera, const Cylinder& crop,
                               double max_range_m);

}  // namespace amiss::segment::internal
