// Pieces of surface in the plane: points with normals from scans, kept once for each place, and a scan's alignment to
// them by point-to-line Gauss-Newton (after Censi, An ICP variant using a point-to-line metric, ICRA 2008).
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/sensors.hpp"

namespace amiss::localize::internal {

/// A point on a surface; the unit normal looks at the laser that saw it.
struct LinePoint {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();
  Eigen::Vector2d n = Eigen::Vector2d::UnitX();
};

/// Where neighbouring beams lie on a line: points on that line, in the base frame.
[[nodiscard]] std::vector<LinePoint> line_points_of(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser);

struct LineAlignment {
  Pose2<Map, Base> T_map_base;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double matched_part = 0.0;  // of the points
};

class LineMap {
 public:
  /// Adds the points where nothing of that direction is nearer than `spacing_m`.
  void add(const std::vector<LinePoint>& points_base, const Pose2<Map, Base>& T_map_base, double spacing_m);
  /// Part of the points that add() with that spacing would add; 1 without points.
  [[nodiscard]] double new_part(const std::vector<LinePoint>& points_base, const Pose2<Map, Base>& T_map_base,
                                double spacing_m) const;
  [[nodiscard]] LineAlignment aligned(const std::vector<LinePoint>& points_base, const Pose2<Map, Base>& guess) const;
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The nearest point within `radius_m` (at most kEdgeM) whose normal agrees.
  [[nodiscard]] std::optional<LinePoint> nearest(const LinePoint& to, double radius_m) const;
  static constexpr double kEdgeM = 0.12;

 private:
  std::unordered_map<std::int64_t, std::vector<LinePoint>> squares_;
  std::size_t size_ = 0;
};

}  // namespace amiss::localize::internal
