#include "sim/internal/noise_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "sim/internal/wide.hpp"

namespace amiss::sim::internal {
namespace {

constexpr std::size_t kReach = kLateralReach;
constexpr std::int32_t kOwnPixels = 3;  // a surface casts no shadow on itself
// Without a step of disparity like this in a row nothing in it can lie kOwnPixels behind another thing.
constexpr float kSteep_px = 0.6F;

using Bytes = std::array<std::uint8_t, kMaxWidth + 2 * kReach>;

/// splitmix64: where in the tables a row begins to read.
std::size_t place(std::uint64_t seed, std::size_t row, std::uint64_t use) {
  std::uint64_t x = seed + 0x9E3779B97F4A7C15ULL * (4 * row + use + 1);
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<std::size_t>((x ^ (x >> 31U)) % kNoiseValues);
}

AMISS_WIDE void mark_jumps(const float* depth, const float* other, std::uint8_t* jumps, std::size_t count, float jump) {
  for (std::size_t i = 0; i < count; ++i)
    jumps[i] = std::abs(depth[i] - other[i]) > jump * std::min(depth[i], other[i]) ? 1 : 0;
}

/// mask = edges and, kReach columns to either side, what is near them. beside[u] tells of the jump from u to u + 1.
AMISS_WIDE void mark_edges(const std::uint8_t* beside, const std::uint8_t* above, const std::uint8_t* below,
                           std::uint8_t* mask, std::size_t w) {
  Bytes edge, two, four;
  std::memset(edge.data(), 0, w + 2 * kReach);
  std::uint8_t* own = edge.data() + kReach;
  for (std::size_t u = 0; u < w; ++u) own[u] = static_cast<std::uint8_t>(beside[u] | above[u] | below[u]);
  for (std::size_t u = 1; u < w; ++u) own[u] = static_cast<std::uint8_t>(own[u] | beside[u - 1]);
  for (std::size_t u = 0; u < w + 5; ++u) two[u] = static_cast<std::uint8_t>(edge[u] | edge[u + 1]);
  for (std::size_t u = 0; u < w + 3; ++u) four[u] = static_cast<std::uint8_t>(two[u] | two[u + 2]);
  for (std::size_t u = 0; u < w; ++u)
    mask[u] = static_cast<std::uint8_t>(own[u] * kEdge | (four[u] | four[u + 3]) * kEdgeNear);
}

/// near = OR of the rows [from, to) of the mask.
AMISS_WIDE void collect(const std::uint8_t* mask, std::size_t w, std::size_t from, std::size_t to, std::uint8_t* near) {
  std::memcpy(near, mask + from * w, w);
  for (std::size_t row = from + 1; row < to; ++row)
    for (std::size_t u = 0; u < w; ++u) near[u] = static_cast<std::uint8_t>(near[u] | mask[row * w + u]);
}

/// The projector's column that each pixel is lit from, plus `most`; true when the disparity steps up somewhere.
AMISS_WIDE bool project(const float* depth, std::size_t w, float fx_times_baseline, float most, std::int32_t* column) {
  std::array<float, kMaxWidth + 1> disparity;
  for (std::size_t u = 0; u < w; ++u) disparity[u] = std::min(fx_times_baseline / std::max(depth[u], 1e-6F), most);
  for (std::size_t u = 0; u < w; ++u) {
    const auto place_px = static_cast<float>(static_cast<std::int32_t>(u));
    column[u] = static_cast<std::int32_t>(place_px - (depth[u] > 0.0F ? disparity[u] : 0.0F) + most);
  }
  std::uint32_t steep = 0;
  for (std::size_t u = 0; u + 1 < w; ++u) steep |= disparity[u + 1] - disparity[u] > kSteep_px ? 1U : 0U;
  return steep != 0;
}

AMISS_WIDE void darken(const std::int32_t* column, const std::int32_t* seen, std::uint8_t* reflectance, std::size_t w) {
  for (std::size_t u = 0; u < w; ++u) {
    const std::int32_t behind = seen[column[u]] - static_cast<std::int32_t>(u);
    reflectance[u] = behind >= kOwnPixels ? std::uint8_t{0} : reflectance[u];
  }
}

/// A row of pixels as the sensor meets them.
struct Row {
  std::array<float, kMaxWidth> depth;
  std::array<std::uint8_t, kMaxWidth> incidence, reflectance;
};

/// Lateral noise: near edges some pixels see what lies beside them.
void displace(const NoiseTables& t, const RenderedFrame& frame, std::size_t row, const std::uint8_t* near,
              std::uint64_t seed, Row& out) {
  const int w = t.intrinsics.width, h = t.intrinsics.height, v = static_cast<int>(row);
  const std::size_t first = row * static_cast<std::size_t>(w);
  const float* aside = t.normal.data() + place(seed, row, 2);
  const float* above = t.normal.data() + place(seed, row, 3);
  const auto jump = static_cast<float>(t.params.edge_jump);
  for (int u = 0; u < w; ++u) {
    const auto i = static_cast<std::size_t>(u);
    std::uint64_t eight = 0;
    if (u + 8 <= w) std::memcpy(&eight, near + i, 8);
    if (u + 8 <= w && eight == 0) {
      u += 7;
      continue;
    }
    if (near[i] == 0) continue;
    const float sigma = t.lateral_px[out.incidence[i]];
    const int du = std::clamp(static_cast<int>(sigma * aside[i] + 64.5F) - 64, -u, w - 1 - u);
    const int dv = std::clamp(static_cast<int>(sigma * above[i] + 64.5F) - 64, -v, h - 1 - v);
    const auto other = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(first + i) + du + dv * w);
    const float mine = frame.depth_m[first + i];
    if (!(std::abs(frame.depth_m[other] - mine) > jump * mine)) continue;
    out.depth[i] = frame.depth_m[other];
    out.incidence[i] = frame.incidence[other];
    out.reflectance[i] = frame.reflectance[other];
  }
}

/// What comes back of the light that meets the surface: losses, then disparity with noise, rounded to steps.
AMISS_WIDE void measure(const NoiseTables& t, const Row& row, const std::uint8_t* mask, const float* normal,
                        const float* uniform, float* out) {
  const auto w = static_cast<std::size_t>(t.intrinsics.width);
  std::array<float, kMaxWidth> flat, signal, kept;
  const auto kept_at_edges = static_cast<float>(1.0 - t.params.edge_loss);
  const auto kept_elsewhere = static_cast<float>(1.0 - t.params.random_loss);
  for (std::size_t u = 0; u < w; ++u) flat[u] = t.flat_m[row.incidence[u]];
  for (std::size_t u = 0; u < w; ++u)
    signal[u] = t.signal[row.incidence[u]] * static_cast<float>(static_cast<std::int32_t>(row.reflectance[u]));
  for (std::size_t u = 0; u < w; ++u) kept[u] = (mask[u] & kEdge) != 0 ? kept_at_edges : kept_elsewhere;
  const float steps_m = t.steps_m, axial = t.axial_scale / steps_m, most = t.max_steps;
  const auto nearest = static_cast<float>(t.params.min_range_m), farthest = static_cast<float>(t.params.max_range_m);
  for (std::size_t u = 0; u < w; ++u) {
    const float z = std::max(row.depth[u], 1e-3F), steps = steps_m / z, far = z - 0.4F;
    // sigma_axial_m, in steps
    const float sigma = (0.0012F + 0.0019F * far * far + flat[u] / std::sqrt(z)) * axial * steps * steps;
    // Rounding to steps adds step^2 / 12 to the variance, so the noise before it is that much smaller.
    const float before = std::sqrt(std::max(sigma * sigma - 1.0F / 12.0F, 0.0F));
    const float noisy = std::min(std::max(steps + before * normal[u] + 0.5F, 0.0F), 1e6F);
    const float measured = steps_m / static_cast<float>(static_cast<std::int32_t>(noisy));
    const bool lit = std::min(signal[u] / (z * z), kept[u]) >= uniform[u];
    const bool in_range = (steps < most) & (measured >= nearest) & (measured <= farthest);
    out[u] = (lit & in_range) ? measured : std::numeric_limits<float>::quiet_NaN();
  }
}

AMISS_WIDE void add_bytes(std::uint8_t* values, const std::int8_t* noise, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto sum = static_cast<std::int16_t>(values[i] + noise[i]);
    values[i] = static_cast<std::uint8_t>(std::min<std::int16_t>(std::max<std::int16_t>(sum, 0), 255));
  }
}

AMISS_WIDE void clean_values(float* depth, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) depth[i] = depth[i] > 0.0F ? depth[i] : 0.0F;
}

}  // namespace

void clean(std::vector<float>& depth_m) { clean_values(depth_m.data(), depth_m.size()); }

std::vector<std::uint8_t> depth_edges(const std::vector<float>& depth_m, int width, float jump) {
  const auto w = static_cast<std::size_t>(width), h = depth_m.size() / w;
  std::vector<std::uint8_t> mask(w * h);
  std::array<Bytes, 2> vertical{};  // jumps from the row above, to the row below
  Bytes beside;
  for (std::size_t row = 0; row < h; ++row) {
    const float* depth = depth_m.data() + row * w;
    mark_jumps(depth, depth + 1, beside.data(), w - 1, jump);
    beside[w - 1] = 0;
    Bytes& below = vertical[(row + 1) % 2];
    if (row + 1 < h)
      mark_jumps(depth, depth + w, below.data(), w, jump);
    else
      below.fill(0);
    mark_edges(beside.data(), vertical[row % 2].data(), below.data(), mask.data() + row * w, w);
  }
  return mask;
}

void darken_shadows(const std::vector<float>& depth_m, std::vector<std::uint8_t>& reflectance, int width,
                    float fx_times_baseline, float least_range_m) {
  const auto w = static_cast<std::size_t>(width), h = depth_m.size() / w;
  const float most = fx_times_baseline / least_range_m;  // disparity in pixels
  std::vector<std::int32_t> column(w), seen(w + static_cast<std::size_t>(most) + 3);
  for (std::size_t row = 0; row < h; ++row) {
    if (!project(depth_m.data() + row * w, w, fx_times_baseline, most, column.data())) continue;
    // The projector's own picture; a pixel covers up to two of its columns. Of two pixels in one column the right one
    // is nearer, so it may overwrite the other one.
    for (std::size_t u = 0; u < w; ++u) {
      const auto id = static_cast<std::int32_t>(u);
      const std::array<std::int32_t, 2> both = {id, id};
      std::memcpy(seen.data() + column[u], both.data(), sizeof(both));
    }
    darken(column.data(), seen.data(), reflectance.data() + row * w, w);
  }
}

std::vector<float> noisy_depth(const NoiseTables& t, RenderedFrame& frame, std::uint64_t seed) {
  const auto w = static_cast<std::size_t>(t.intrinsics.width), h = static_cast<std::size_t>(t.intrinsics.height);
  const std::vector<std::uint8_t> mask =
      depth_edges(frame.depth_m, t.intrinsics.width, static_cast<float>(t.params.edge_jump));
  darken_shadows(frame.depth_m, frame.reflectance, t.intrinsics.width,
                 static_cast<float>(t.intrinsics.fx * t.params.baseline_m), static_cast<float>(t.params.min_range_m));
  std::vector<float> out(w * h);
  Row here;
  Bytes near;
  for (std::size_t row = 0; row < h; ++row) {
    const std::size_t first = row * w;
    std::memcpy(here.depth.data(), frame.depth_m.data() + first, w * sizeof(float));
    std::memcpy(here.incidence.data(), frame.incidence.data() + first, w);
    std::memcpy(here.reflectance.data(), frame.reflectance.data() + first, w);
    collect(mask.data(), w, row - std::min(row, kReach), std::min(row + kReach + 1, h), near.data());
    displace(t, frame, row, near.data(), seed, here);
    measure(t, here, mask.data() + first, t.normal.data() + place(seed, row, 0), t.uniform.data() + place(seed, row, 1),
            out.data() + first);
  }
  return out;
}

void add_colour_noise(const NoiseTables& t, std::vector<Rgb>& colour, std::uint64_t seed) {
  const auto w = static_cast<std::size_t>(t.intrinsics.width);
  for (std::size_t row = 0; (row + 1) * w <= colour.size(); ++row)
    add_bytes(reinterpret_cast<std::uint8_t*>(colour.data() + row * w),  // three bytes a pixel
              t.colour.data() + 3 * place(~seed, row, 0), 3 * w);
}

}  // namespace amiss::sim::internal
