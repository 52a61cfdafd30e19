// How far the rays of a depth image free the space, with the smallest and largest of it over growing squares of pixels.
#pragma once

#include <vector>

#include "core/sensors.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

/// Pixels first .. last, both included.
struct PixelRect {
  int u_first = 0, u_last = -1, v_first = 0, v_last = -1;
};

/// Row `row` of the image of every step-th pixel, packed into `packed` where step is not 1.
[[nodiscard]] const float* sampled_row(const RgbdFrame& frame, std::size_t step, std::size_t row,
                                       std::vector<float>& packed);

/// Every pixel_step-th pixel of the frame. reach = 0 where the pixel says nothing.
class DepthPyramid {
 public:
  void build(const RgbdFrame& frame, const VoxelMapParams& params);
  /// Of a reach that somebody else worked out, row-major.
  void build(const std::vector<float>& reach, int width, int height);

  [[nodiscard]] int width() const { return levels_.front().width; }
  [[nodiscard]] int height() const { return levels_.front().height; }
  [[nodiscard]] const float* reach() const { return levels_.front().low.data(); }

  struct Range {
    float low = 0.0f, high = 0.0f;
  };
  /// Bounds of the reach over a rectangle inside the image: never too tight.
  [[nodiscard]] Range range(const PixelRect& rect) const;

 private:
  struct Level {
    int width = 0, height = 0;
    std::vector<float> low, high;  // of level 0 only low is filled
  };
  void raise();
  void halve(const Level& fine, bool finest, Level& coarse) const;

  std::vector<Level> levels_;
  std::vector<float> packed_;
};

}  // namespace amiss::mapping
