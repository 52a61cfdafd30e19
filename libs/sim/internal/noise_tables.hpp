// Everything about the depth noise that can be computed once: what remains for each pixel is looking up.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/depth_noise.hpp"

namespace amiss::sim::internal {

inline constexpr std::size_t kNoiseValues = 65536;  // of each table of random numbers, continued at its end by a row
inline constexpr std::size_t kMaxWidth = 4096;

struct NoiseTables {
  NoiseTables(const DepthNoiseParams& params, const CameraIntrinsics& intrinsics);

  DepthNoiseParams params;
  CameraIntrinsics intrinsics;
  float steps_m;    // disparity in steps = steps_m / z
  float max_steps;  // where the minimum range lies
  float axial_scale;
  std::array<float, 256> lateral_px;  // sigma, by incidence byte, as below
  std::array<float, 256> flat_m;      // what grazing adds to sigma_axial, times sqrt(z)
  std::array<float, 256> signal;      // of reflectance 1 at z = 1; below a number of `uniform` nothing comes back
  std::vector<float> normal;          // random numbers
  std::vector<float> uniform;
  std::vector<std::int8_t> colour;  // three times as many
};

}  // namespace amiss::sim::internal
