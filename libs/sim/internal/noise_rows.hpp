// The loops of the depth noise over pixels. They run in two passes over the rows: what depends on a row alone (edges,
// the projector's shadow), then what pixels near edges exchange, and the noise itself.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/internal/noise_tables.hpp"

namespace amiss::sim::internal {

inline constexpr std::uint8_t kEdge = 1;      // a jump of depth lies beside this pixel
inline constexpr std::uint8_t kEdgeNear = 2;  // ... or beside one within kLateralReach columns
inline constexpr int kLateralReach = 3;       // pixels; sigma is about one

/// Depth 0 where nothing is, or where it is no number.
void clean(std::vector<float>& depth_m);

/// kEdge next to a jump of more than `jump` of the depth, kEdgeNear beside those. Depth is 0 where nothing is.
[[nodiscard]] std::vector<std::uint8_t> depth_edges(const std::vector<float>& depth_m, int width, float jump);

/// Reflectance becomes 0 where the projector, on the right of the camera, cannot shine to because something nearer is
/// in its way: a surface that lies less than two pixels of disparity behind another one stays lit.
void darken_shadows(const std::vector<float>& depth_m, std::vector<std::uint8_t>& reflectance, int width,
                    float fx_times_baseline, float least_range_m);

/// Noise, rounding and losses. `seed` decides on all that is random; the frame is used up.
[[nodiscard]] std::vector<float> noisy_depth(const NoiseTables& tables, RenderedFrame& frame, std::uint64_t seed);

void add_colour_noise(const NoiseTables& tables, std::vector<Rgb>& colour, std::uint64_t seed);

}  // namespace amiss::sim::internal
