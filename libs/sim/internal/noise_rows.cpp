#include "sim/internal/noise_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace amiss::sim::internal {
namespace {

constexpr int kLateralReach = 3;          // pixels; sigma is about one
constexpr float kOwnDisparity_px = 1.5F;  // a surface casts no shadow on itself

/// splitmix64: where in the tables a row begins to read.
std::size_t place(std::uint64_t seed, std::size_t row, std::uint64_t use) {
  std::uint64_t x = seed + 0x9E3779B97F4A7C15ULL * (4 * row + use + 1);
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<std::size_t>((x ^ (x >> 31U)) % kNoiseValues);
}

void mark_jumps(const float* depth, const float* other, std::uint8_t* mask, std::uint8_t* other_mask, std::size_t count,
                float jump) {
  for (std::size_t i = 0; i < count; ++i) {
    const float a = depth[i], b = other[i];
    const std::uint8_t jumps = std::abs(a - b) > jump * std::min(a, b) ? 1 : 0;
    mask[i] |= jumps;
    other_mask[i] |= jumps;
  }
}

struct Row {
  const NoiseTables& t;
  const float* depth;  // of the row's first pixel, as all below
  const std::uint8_t* incidence;
  const std::uint8_t* reflectance;
  const float* normal;
  const float* uniform;

  /// What comes back of the light that meets the surface of pixel `at`, drawn for pixel `u`.
  [[nodiscard]] float measure(std::ptrdiff_t at, std::size_t u, float kept) const {
    constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
    const float steps = t.steps_m / depth[at];  // infinite where nothing is
    if (!(steps < static_cast<float>(t.max_step))) return kNothing;
    const std::size_t cell = static_cast<std::size_t>(steps) * kAngleBins + t.angle_bin[incidence[at]];
    if (std::min(t.signal[cell] * static_cast<float>(reflectance[at]), kept) < uniform[u]) return kNothing;
    const float rounded = steps + t.axial_steps[cell] * normal[u] + 0.5F;
    const auto step = static_cast<std::size_t>(std::max(rounded, 0.0F));
    return t.depth_of_step[std::min(step, t.max_step + 1)];
  }
};

}  // namespace

std::vector<std::uint8_t> depth_edges(const std::vector<float>& depth_m, int width, int height, float jump) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  std::vector<std::uint8_t> edges(w * h, 0);
  for (std::size_t row = 0; row < h; ++row) {
    const float* depth = depth_m.data() + row * w;
    std::uint8_t* mask = edges.data() + row * w;
    std::array<std::uint8_t, kMaxWidth> jumps;  // two passes, so that each can be done for many pixels at once
    for (std::size_t u = 0; u + 1 < w; ++u)
      jumps[u] = std::abs(depth[u] - depth[u + 1]) > jump * std::min(depth[u], depth[u + 1]) ? 1 : 0;
    for (std::size_t u = 0; u + 1 < w; ++u) mask[u] |= jumps[u];
    for (std::size_t u = 0; u + 1 < w; ++u) mask[u + 1] |= jumps[u];
    if (row + 1 < h) mark_jumps(depth, depth + w, mask, mask + w, w, jump);
  }
  return edges;
}

std::vector<std::uint8_t> dilated(const std::vector<std::uint8_t>& mask, int width, int height, int reach) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  const auto r = static_cast<std::size_t>(reach);
  std::vector<std::uint8_t> wide(mask), out;
  for (std::size_t row = 0; row < h; ++row)
    for (std::size_t shift = 1; shift <= r && shift < w; ++shift) {
      const std::uint8_t* in = mask.data() + row * w;
      std::uint8_t* to = wide.data() + row * w;
      for (std::size_t u = 0; u + shift < w; ++u) to[u] |= in[u + shift];
      for (std::size_t u = shift; u < w; ++u) to[u] |= in[u - shift];
    }
  out = wide;
  for (std::size_t shift = 1; shift <= r && shift < h; ++shift) {
    const std::size_t offset = shift * w;
    for (std::size_t i = 0; i + offset < out.size(); ++i) out[i] |= wide[i + offset];
    for (std::size_t i = offset; i < out.size(); ++i) out[i] |= wide[i - offset];
  }
  return out;
}

std::vector<std::uint8_t> projector_shadow(const std::vector<float>& depth_m, int width, int height,
                                           float fx_times_baseline, float least_range_m) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  std::vector<std::uint8_t> shadow(w * h, 0);
  const float most = fx_times_baseline / least_range_m;  // disparity in pixels
  std::vector<float> disparity(w), nearest(w + static_cast<std::size_t>(most) + 3);
  std::vector<std::int32_t> column(w);
  for (std::size_t row = 0; row < h; ++row) {
    const float* depth = depth_m.data() + row * w;
    for (std::size_t u = 0; u < w; ++u) {
      disparity[u] = depth[u] > 0.0F ? std::min(fx_times_baseline / depth[u], most) : 0.0F;
      column[u] = static_cast<std::int32_t>(static_cast<float>(static_cast<std::int32_t>(u)) - disparity[u] + most);
    }
    std::fill(nearest.begin(), nearest.end(), 0.0F);
    for (std::size_t u = 0; u < w; ++u) {  // the projector's own picture; a pixel covers up to two of its columns
      float* seen = nearest.data() + column[u];
      seen[0] = std::max(seen[0], disparity[u]);
      seen[1] = std::max(seen[1], disparity[u]);
    }
    std::uint8_t* out = shadow.data() + row * w;
    for (std::size_t u = 0; u < w; ++u)
      out[u] = nearest[static_cast<std::size_t>(column[u])] > disparity[u] + kOwnDisparity_px ? 1 : 0;
  }
  return shadow;
}

std::vector<float> noisy_depth(const NoiseTables& t, const RenderedFrame& frame, const std::vector<float>& depth_m,
                               std::uint64_t seed) {
  const int width = t.intrinsics.width, height = t.intrinsics.height;
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  const std::vector<std::uint8_t> edges = depth_edges(depth_m, width, height, static_cast<float>(t.params.edge_jump));
  const std::vector<std::uint8_t> near_edges = dilated(edges, width, height, kLateralReach);
  const std::vector<std::uint8_t> shadow =
      projector_shadow(depth_m, width, height, static_cast<float>(t.intrinsics.fx * t.params.baseline_m),
                       static_cast<float>(t.params.min_range_m));
  const std::array<float, 2> kept = {static_cast<float>(1.0 - t.params.random_loss),
                                     static_cast<float>(1.0 - t.params.edge_loss)};
  std::vector<float> out(w * h);
  for (std::size_t row = 0; row < h; ++row) {
    const std::size_t first = row * w;
    const Row here{t,
                   depth_m.data() + first,
                   frame.incidence.data() + first,
                   frame.reflectance.data() + first,
                   t.normal.data() + place(seed, row, 0),
                   t.uniform.data() + place(seed, row, 1)};
    const float* aside = t.normal.data() + place(seed, row, 2);
    const float* above = t.normal.data() + place(seed, row, 3);
    for (std::size_t u = 0; u < w; ++u) {
      std::ptrdiff_t at = static_cast<std::ptrdiff_t>(u);
      if (near_edges[first + u] != 0) {  // lateral noise: the edge seems to be elsewhere
        const float sigma = t.lateral_px[t.angle_bin[here.incidence[u]]];
        const long du = std::clamp(std::lround(sigma * aside[u]), -static_cast<long>(u), static_cast<long>(w - 1 - u));
        const long dv =
            std::clamp(std::lround(sigma * above[u]), -static_cast<long>(row), static_cast<long>(h - 1 - row));
        const std::ptrdiff_t other = at + du + dv * width;
        if (std::abs(here.depth[other] - here.depth[u]) > static_cast<float>(t.params.edge_jump) * here.depth[u])
          at = other;
      }
      const bool dark = shadow[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(first) + at)] != 0;
      out[first + u] = dark ? std::numeric_limits<float>::quiet_NaN() : here.measure(at, u, kept[edges[first + u]]);
    }
  }
  return out;
}

void add_colour_noise(const NoiseTables& t, std::vector<Rgb>& colour, std::uint64_t seed) {
  const auto w = static_cast<std::size_t>(t.intrinsics.width);
  for (std::size_t row = 0; (row + 1) * w <= colour.size(); ++row) {
    auto* values = reinterpret_cast<std::uint8_t*>(colour.data() + row * w);  // three bytes a pixel
    const std::int8_t* noise = t.colour.data() + 3 * place(~seed, row, 0);
    for (std::size_t i = 0; i < 3 * w; ++i)
      values[i] =
          static_cast<std::uint8_t>(std::clamp(static_cast<int>(values[i]) + static_cast<int>(noise[i]), 0, 255));
  }
}

}  // namespace amiss::sim::internal
