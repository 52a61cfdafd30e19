// The loops of the depth noise over pixels. Depth in them is 0 where nothing is.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/internal/noise_tables.hpp"

namespace amiss::sim::internal {

/// 1 at pixels next to a jump of depth (of more than `jump` of the depth).
[[nodiscard]] std::vector<std::uint8_t> depth_edges(const std::vector<float>& depth_m, int width, int height,
                                                    float jump);

/// Not 0 within `reach` pixels (in rows and columns) of what is not 0.
[[nodiscard]] std::vector<std::uint8_t> dilated(const std::vector<std::uint8_t>& mask, int width, int height,
                                                int reach);

/// 1 where the projector, `baseline` to the right of the camera, cannot shine to because something nearer is in its
/// way.
[[nodiscard]] std::vector<std::uint8_t> projector_shadow(const std::vector<float>& depth_m, int width, int height,
                                                         float fx_times_baseline, float least_range_m);

/// Noise, rounding and losses. `seed` decides on all that is random.
[[nodiscard]] std::vector<float> noisy_depth(const NoiseTables& tables, const RenderedFrame& frame,
                                             const std::vector<float>& depth_m, std::uint64_t seed);

void add_colour_noise(const NoiseTables& tables, std::vector<Rgb>& colour, std::uint64_t seed);

}  // namespace amiss::sim::internal
