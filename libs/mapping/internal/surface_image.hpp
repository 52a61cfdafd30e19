// A depth image prepared for a TSDF: where each pixel's ray meets a surface, where it only frees space, and the mean of
// pixels that lie on one surface.
//
// A pixel's code: z > 0 [m] where the ray meets the surface; -z where the ray is longer than the range and frees space
// up to z; 0 where it says nothing.
#pragma once

#include <vector>

#include "mapping/internal/depth_pyramid.hpp"
#include "mapping/surface_map.hpp"

namespace amiss::mapping {

class SurfaceImage {
 public:
  static constexpr int kLevels = 4;  // 1, 2, 4, 8 pixels

  void prepare(const RgbdFrame& frame, const SurfaceParams& params);

  /// Codes of level 0; in level l the mean z of 2^l x 2^l pixels, 0 where they are not all of one surface.
  [[nodiscard]] const float* codes(int level) const { return codes_[static_cast<std::size_t>(level)].data(); }
  [[nodiscard]] int width(int level) const { return (width_ + (1 << level) - 1) >> level; }
  [[nodiscard]] int height(int level) const { return (height_ + (1 << level) - 1) >> level; }
  /// How far rays free space beyond doubt: a truncation before the surface.
  [[nodiscard]] const DepthPyramid& reach() const { return pyramid_; }

 private:
  void read_rows(const RgbdFrame& frame, const SurfaceParams& params);
  void halve(int level, float most_apart_m);

  int width_ = 0, height_ = 0;
  std::vector<float> codes_[kLevels], reach_;
  DepthPyramid pyramid_;
};

}  // namespace amiss::mapping
