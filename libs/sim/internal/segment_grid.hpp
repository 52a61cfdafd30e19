// Segments of a plane in buckets, for ray casting: a ray visits the cells along it (Amanatides and Woo 1987) until a
// hit lies before the end of the cell.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/laser.hpp"

namespace amiss::sim::internal {

/// Distance from `origin` along the unit vector `direction` to a segment, or infinity.
[[nodiscard]] double hit(const Segment2& segment, const Eigen::Vector2d& origin, const Eigen::Vector2d& direction);

class SegmentGrid {
 public:
  explicit SegmentGrid(const std::vector<Segment2>& segments);

  /// Distance to the first segment, or infinity where there is none up to max_m.
  [[nodiscard]] double cast(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double max_m) const;

 private:
  struct Stored {
    double ax, ay, ex, ey;  // start and extent
  };
  [[nodiscard]] std::vector<std::uint32_t> cells_of(const Segment2& segment) const;

  double cell_m_ = 0.25;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero(), high_ = Eigen::Vector2d::Zero();
  int width_ = 0, height_ = 0;
  std::vector<std::uint32_t> first_;  // of each cell in stored_; one more at the end
  std::vector<Stored> stored_;        // cell by cell
};

}  // namespace amiss::sim::internal
