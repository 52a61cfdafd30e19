// How much of a box is surface, for any box at once: sums over all cells below and before each cell (a summed-area
// table in three dimensions).
// in: cells 0 .. size - 1     out: how many cells of a box were set; boxes may reach out of the volume
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace amiss::semantics {

class SummedVolume {
 public:
  /// ArgumentError where it would not fit into memory.
  explicit SummedVolume(const Eigen::Vector3i& size);

  void set(const Eigen::Vector3i& cell) { at(cell + Eigen::Vector3i::Ones()) = 1; }
  /// After the last set().
  void sum_up();

  /// Cells low <= cell < high.
  [[nodiscard]] int count(const Eigen::Vector3i& low, const Eigen::Vector3i& high) const {
    const Eigen::Vector3i a = clamped(low), b = clamped(high);
    if ((b.array() <= a.array()).any()) return 0;
    return layer(a, b, b.z()) - layer(a, b, a.z());
  }
  [[nodiscard]] const Eigen::Vector3i& size() const { return size_; }

 private:
  [[nodiscard]] std::size_t place(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(size_.y() + 1) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_.z() + 1) +
           static_cast<std::size_t>(z);
  }
  [[nodiscard]] std::int32_t& at(const Eigen::Vector3i& p) { return sums_[place(p.x(), p.y(), p.z())]; }
  [[nodiscard]] Eigen::Vector3i clamped(const Eigen::Vector3i& p) const { return p.cwiseMax(0).cwiseMin(size_); }
  [[nodiscard]] int layer(const Eigen::Vector3i& a, const Eigen::Vector3i& b, int z) const {
    return sums_[place(b.x(), b.y(), z)] - sums_[place(a.x(), b.y(), z)] - sums_[place(b.x(), a.y(), z)] +
           sums_[place(a.x(), a.y(), z)];
  }

  Eigen::Vector3i size_;
  std::vector<std::int32_t> sums_;
};

}  // namespace amiss::semantics
