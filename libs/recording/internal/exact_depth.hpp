// A depth image as a rawlog keeps it: millimetres in 16 bits for every program, and beside them what rounding took
// away, as the distance of the two floats in steps of the last bit, so that depth comes back as it was to the last bit.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace amiss::recording::internal {

inline constexpr float kDepthUnitM = 0.001F;
inline constexpr float kMostDepthM = 65.0F;  // of 16 bits

/// 0 where nothing came back.
inline std::uint16_t millimetres(float depth_m) {
  const bool valid = depth_m > 0.0F && depth_m < kMostDepthM;
  return valid ? static_cast<std::uint16_t>(depth_m / kDepthUnitM + 0.5F) : std::uint16_t{0};
}
inline std::uint32_t bits_of(std::uint16_t millimetres) {
  return std::bit_cast<std::uint32_t>(millimetres == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                       : static_cast<float>(millimetres) * kDepthUnitM);
}
inline std::uint32_t rest(float depth_m, std::uint16_t millimetres) {
  return std::bit_cast<std::uint32_t>(depth_m) - bits_of(millimetres);
}
inline float exact_depth(std::uint16_t millimetres, std::uint32_t rest) {
  return std::bit_cast<float>(bits_of(millimetres) + rest);
}

}  // namespace amiss::recording::internal
