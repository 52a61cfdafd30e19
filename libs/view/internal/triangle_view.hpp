// Which cells of a grid can be seen inside a triangle: cells from near to far, a blocked one casts its shadow over the
// directions that it takes up, a cell is seen when its own direction is not in shadow yet.
#pragma once

#include <cstdint>
#include <vector>

#include "core/floor_grid.hpp"

namespace amiss::view::internal {

class TriangleView {
 public:
  /// The grid must outlive the view.
  TriangleView(const FloorGrid& sight, double angle_rad, double height_m);

  /// Indices of the free cells whose centres lie in the triangle and are not hidden. The apex is put into the middle of
  /// its cell; nothing is seen when that is not free.
  [[nodiscard]] const std::vector<std::uint32_t>& from(const Pose2<Map, Base>& T_map_base);

 private:
  struct Offset {
    std::int16_t dx, dy;
    float x_m, y_m;
    std::int32_t index;          // added to the index of the apex' cell
    std::uint16_t bin;           // direction of the centre
    std::uint16_t first, count;  // directions that the cell takes up
  };

  void look_into(std::size_t sector, Cell apex, float cosine, float sine);

  const FloorGrid& sight_;
  double half_angle_rad_;
  float slope_;  // of the sides of the triangle
  float height_m_;
  std::vector<std::vector<Offset>> sectors_;  // near ones first; a cell is in all sectors that it reaches into
  std::vector<std::uint8_t> shadow_;
  std::vector<std::uint32_t> seen_;
};

}  // namespace amiss::view::internal
