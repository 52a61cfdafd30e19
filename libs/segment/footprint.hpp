// What part of the floor plan something covers: a bitmap of square cells in x and y of the map frame.
// in: points [m]. out: contains(x, y), area [m2]; grown, filled, united with another.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace amiss::segment {

class Footprint {
 public:
  explicit Footprint(float cell_m = 0.02F) : cell_m_(cell_m) {}
  Footprint(const std::vector<Eigen::Vector3f>& points, const std::vector<std::uint32_t>& among, float cell_m = 0.02F);

  [[nodiscard]] bool contains(float x_m, float y_m) const { return at(cell_of(x_m), cell_of(y_m)); }
  [[nodiscard]] double area_m2() const;
  /// Every cell grown by so many cells in x and y.
  [[nodiscard]] Footprint dilated(int cells) const;
  /// Holes that no way of side by side cells joins with the outside are filled.
  [[nodiscard]] Footprint filled() const;
  [[nodiscard]] Footprint united(const Footprint& other) const;  // cells of equal size
  [[nodiscard]] double shared_area_m2(const Footprint& other) const;

 private:
  [[nodiscard]] int cell_of(float v_m) const;
  [[nodiscard]] bool at(int x, int y) const {
    return x >= x0_ && y >= y0_ && x < x0_ + width_ && y < y0_ + height_ && bits_[index(x, y)];
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - y0_) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x - x0_);
  }
  /// An empty bitmap over the cells x0 .. x1 and y0 .. y1.
  [[nodiscard]] Footprint blank(int x0, int y0, int x1, int y1) const;
  template <class Visit>
  void for_each(Visit visit) const;

  float cell_m_;
  int x0_ = 0, y0_ = 0, width_ = 0, height_ = 0;
  std::vector<bool> bits_;
};

}  // namespace amiss::segment
