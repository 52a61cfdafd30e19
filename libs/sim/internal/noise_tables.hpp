// Everything about the depth noise that can be computed once: what remains for each pixel is looking up.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/depth_noise.hpp"

namespace amiss::sim::internal {

inline constexpr std::size_t kNoiseValues = 65536;  // of each table of random numbers, continued at its end by a row
inline constexpr std::size_t kAngleBins = 48;
inline constexpr std::size_t kMaxWidth = 4096;

struct NoiseTables {
  NoiseTables(const DepthNoiseParams& params, const CameraIntrinsics& intrinsics);

  DepthNoiseParams params;
  CameraIntrinsics intrinsics;
  float steps_m;                             // disparity in steps = steps_m / z
  std::size_t max_step;                      // where the minimum range lies
  std::vector<float> depth_of_step;          // [m], NaN outside of the range
  std::array<std::uint8_t, 256> angle_bin;   // of an incidence byte
  std::array<float, kAngleBins> lateral_px;  // sigma
  std::vector<float> axial_steps;            // sigma in steps: [step * kAngleBins + angle_bin]
  std::vector<float> signal;                 // of reflectance 1: [step * kAngleBins + angle_bin]; below a
                                             // number of `uniform` nothing comes back
  std::vector<float> normal;                 // random numbers
  std::vector<float> uniform;
  std::vector<std::int8_t> colour;  // three times as many
};

}  // namespace amiss::sim::internal
