#include "mapping/internal/depth_pyramid.hpp"

#include <algorithm>
#include <limits>

#include "mapping/internal/wide.hpp"

namespace amiss::mapping {
namespace {

struct ReachLimits {
  float min_range, max_hit, max_range, voxel;
};

AMISS_WIDE void reach_of_row(const float* depth, std::size_t n, ReachLimits limits, float* reach) {
  for (std::size_t i = 0; i < n; ++i) {
    const float d = depth[i];
    const float beyond = std::min(d - limits.voxel, limits.max_range);
    const float reaches = d <= limits.max_hit ? d : beyond;
    reach[i] = d >= limits.min_range && d <= std::numeric_limits<float>::max() ? reaches : 0.0f;
  }
}

}  // namespace

const float* sampled_row(const RgbdFrame& frame, std::size_t step, std::size_t row, std::vector<float>& packed) {
  const auto width = static_cast<std::size_t>(frame.intrinsics.width);
  const float* from = &frame.depth_m[row * step * width];
  if (step == 1) return from;
  packed.resize((width + step - 1) / step);
  for (std::size_t i = 0; i < packed.size(); ++i) packed[i] = from[i * step];
  return packed.data();
}

void DepthPyramid::build(const RgbdFrame& frame, const VoxelMapParams& params) {
  const int step = params.pixel_step;
  const ReachLimits limits{static_cast<float>(params.min_range_m), static_cast<float>(params.max_hit_range_m),
                           static_cast<float>(params.max_range_m), static_cast<float>(params.resolution_m)};
  if (levels_.empty()) levels_.resize(1);
  Level& finest = levels_.front();
  finest.width = (frame.intrinsics.width + step - 1) / step;
  finest.height = (frame.intrinsics.height + step - 1) / step;
  const auto w = static_cast<std::size_t>(finest.width);
  finest.low.resize(w * static_cast<std::size_t>(finest.height));
  for (std::size_t row = 0; row < static_cast<std::size_t>(finest.height); ++row) {
    const float* depth = sampled_row(frame, static_cast<std::size_t>(step), row, packed_);
    reach_of_row(depth, w, limits, &finest.low[row * w]);
  }
  raise();
}

void DepthPyramid::build(const std::vector<float>& reach, int width, int height) {
  if (levels_.empty()) levels_.resize(1);
  levels_.front().width = width;
  levels_.front().height = height;
  levels_.front().low = reach;
  raise();
}

void DepthPyramid::raise() {
  std::size_t level = 0;
  while (levels_[level].width > 2 || levels_[level].height > 2) {
    if (levels_.size() == level + 1) levels_.emplace_back();
    halve(levels_[level], level == 0, levels_[level + 1]);
    ++level;
  }
  levels_.resize(level + 1);
}

void DepthPyramid::halve(const Level& fine, bool finest, Level& coarse) const {
  coarse.width = (fine.width + 1) / 2;
  coarse.height = (fine.height + 1) / 2;
  const auto w = static_cast<std::size_t>(coarse.width), fine_w = static_cast<std::size_t>(fine.width);
  coarse.low.resize(w * static_cast<std::size_t>(coarse.height));
  coarse.high.resize(coarse.low.size());
  const std::vector<float>& high = finest ? fine.low : fine.high;
  for (int v = 0; v < coarse.height; ++v) {
    const std::size_t row = static_cast<std::size_t>(2 * v) * fine_w;
    const std::size_t next = static_cast<std::size_t>(std::min(2 * v + 1, fine.height - 1)) * fine_w;
    const std::size_t to = static_cast<std::size_t>(v) * w;
    for (std::size_t u = 0; u < w; ++u) {
      const std::size_t a = 2 * u, b = std::min(2 * u + 1, fine_w - 1);
      coarse.low[to + u] =
          std::min(std::min(fine.low[row + a], fine.low[row + b]), std::min(fine.low[next + a], fine.low[next + b]));
      coarse.high[to + u] = std::max(std::max(high[row + a], high[row + b]), std::max(high[next + a], high[next + b]));
    }
  }
}

DepthPyramid::Range DepthPyramid::range(const PixelRect& rect) const {
  unsigned level = 0;
  while (level + 1 < levels_.size() && ((rect.u_last >> level) - (rect.u_first >> level) > 2 ||
                                        (rect.v_last >> level) - (rect.v_first >> level) > 2)) {
    ++level;
  }
  const Level& at = levels_[level];
  const std::vector<float>& high = level == 0 ? at.low : at.high;
  Range range{std::numeric_limits<float>::max(), 0.0f};
  for (int v = rect.v_first >> level; v <= rect.v_last >> level; ++v) {
    for (int u = rect.u_first >> level; u <= rect.u_last >> level; ++u) {
      const std::size_t i =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(at.width) + static_cast<std::size_t>(u);
      range.low = std::min(range.low, at.low[i]);
      range.high = std::max(range.high, high[i]);
    }
  }
  return range;
}

}  // namespace amiss::mapping
