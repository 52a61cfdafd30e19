// Cells of a cubic grid as one number, for hash tables.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace amiss::semantics {

/// 21 bits for each index: cells of 1 cm reach over 10 km.
inline std::uint64_t cell_key(const Eigen::Vector3i& cell) {
  constexpr std::uint64_t kBits = 21, kMask = (std::uint64_t{1} << kBits) - 1;
  constexpr std::int64_t kMiddle = std::int64_t{1} << (kBits - 1);
  const auto part = [](int index) { return static_cast<std::uint64_t>(index + kMiddle) & kMask; };
  return part(cell.x()) | (part(cell.y()) << kBits) | (part(cell.z()) << (2 * kBits));
}

inline Eigen::Vector3i cell_of(const Eigen::Vector3f& p, double edge_m) {
  return (p.cast<double>() / edge_m).array().floor().cast<int>();
}

/// Points that cell_of can take.
inline bool is_near(const Eigen::Vector3f& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() < 5000.0F; }

/// splitmix64's finalizer.
inline std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31U);
}

/// f(offset) for the 27 cells around a cell, z first, the cell itself among them.
template <class F>
void for_neighbours(const F& f) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) f(Eigen::Vector3i(x, y, z));
    }
  }
}

}  // namespace amiss::semantics
