#include "mapping/internal/surface_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mapping/internal/wide.hpp"

namespace amiss::mapping {
namespace {

/// Pixels whose depth spreads more than so many voxels are not averaged.
constexpr double kOneSurfaceVoxels = 2.0;

struct RowLimits {
  float min_range, max_range, truncation;
  float inverse_fx, cx, y2;  // y2: 1 + (y / z)^2 of the row
};

AMISS_WIDE void read_row(const float* depth, int n, RowLimits l, float* code, float* reach) {
  for (int i = 0; i < n; ++i) {
    const float x = (static_cast<float>(i) - l.cx) * l.inverse_fx;
    const float stretch = std::sqrt(x * x + l.y2);  // length of the ray for a z of 1
    const float d = depth[i];
    const float cut = l.truncation / stretch, longest = l.max_range / stretch;
    const bool there = d >= l.min_range && d <= std::numeric_limits<float>::max();
    const bool hit = d * stretch <= l.max_range;
    const float frees = std::max(std::min(d - cut, longest), 0.0f);
    code[i] = there ? (hit ? d : -frees) : 0.0f;
    reach[i] = there ? frees : 0.0f;
  }
}

AMISS_WIDE void halve_row(const float* above, const float* below, int n, float most_apart, float* mean) {
  for (int i = 0; i < n; ++i) {
    const float a = above[2 * i], b = above[2 * i + 1], c = below[2 * i], d = below[2 * i + 1];
    const float low = std::min(std::min(a, b), std::min(c, d)), high = std::max(std::max(a, b), std::max(c, d));
    const float average = 0.25f * ((a + b) + (c + d));
    mean[i] = low > 0.0f && high - low <= most_apart ? average : 0.0f;
  }
}

}  // namespace

void SurfaceImage::read_rows(const RgbdFrame& frame, const SurfaceParams& params) {
  const CameraIntrinsics& k = frame.intrinsics;
  const std::size_t pixels = frame.depth_m.size();
  codes_[0].resize(pixels);
  reach_.resize(pixels);
  for (int row = 0; row < height_; ++row) {
    const double y = (row - k.cy) / k.fy;
    const RowLimits limits{static_cast<float>(params.min_range_m),
                           static_cast<float>(params.max_range_m),
                           static_cast<float>(params.truncation_m()),
                           static_cast<float>(1.0 / k.fx),
                           static_cast<float>(k.cx),
                           static_cast<float>(1.0 + y * y)};
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
    read_row(&frame.depth_m[at], width_, limits, &codes_[0][at], &reach_[at]);
  }
}

void SurfaceImage::halve(int level, float most_apart_m) {
  const std::vector<float>& fine = codes_[level - 1];
  const auto fine_width = static_cast<std::size_t>(width(level - 1)), w = static_cast<std::size_t>(width(level));
  const int whole_columns = width(level - 1) / 2, whole_rows = height(level - 1) / 2;
  std::vector<float>& coarse = codes_[level];
  coarse.assign(w * static_cast<std::size_t>(height(level)), 0.0f);  // what is cut by the border has no mean
  for (int row = 0; row < whole_rows; ++row) {
    const std::size_t above = static_cast<std::size_t>(2 * row) * fine_width;
    halve_row(&fine[above], &fine[above + fine_width], whole_columns, most_apart_m,
              &coarse[static_cast<std::size_t>(row) * w]);
  }
}

void SurfaceImage::prepare(const RgbdFrame& frame, const SurfaceParams& params) {
  width_ = frame.intrinsics.width;
  height_ = frame.intrinsics.height;
  read_rows(frame, params);
  const auto most_apart_m = static_cast<float>(kOneSurfaceVoxels * params.voxel_m);
  for (int level = 1; level < kLevels; ++level) halve(level, most_apart_m);
  pyramid_.build(reach_, width_, height_);
}

}  // namespace amiss::mapping
