// The distance to the nearest wall of a map, interpolated, and a scan's points aligned to it.
#pragma once

#include <vector>

#include "core/floor_grid.hpp"
#include "core/sensors.hpp"

namespace amiss::localize::internal {

/// Of a point so far from any wall (Geman and McClure): its square over twice the variance where that is near for the
/// kernel, limited where it is far.
[[nodiscard]] double robust_cost(double distance_m, double kernel_m);
inline constexpr double kLastKernelM = 0.06;  // of the alignment's last steps

class DistanceField {
 public:
  explicit DistanceField(const FloorGrid& map);

  struct Sample {
    double distance_m = 0.0;
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  };
  /// Bilinear between cell centres; kFar without a gradient outside of the map.
  [[nodiscard]] Sample at(const Eigen::Vector2d& p_map) const;
  static constexpr double kFar = 10.0;

  /// The map, and for each of its cells the distance and the robust cost of a point at the cell's centre.
  [[nodiscard]] const FloorGrid& map() const { return map_; }
  [[nodiscard]] const std::vector<float>& cell_distances_m() const { return distance_m_; }
  [[nodiscard]] const std::vector<float>& cell_costs() const { return cell_costs_; }

 private:
  FloorGrid map_;
  std::vector<float> distance_m_;
  std::vector<float> cell_costs_;
};

/// At most max_points valid returns in the base frame, evenly taken.
[[nodiscard]] std::vector<Eigen::Vector2d> points_of(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser,
                                                     int max_points);

/// Part of the points within `near_m` of a wall.
[[nodiscard]] double fit_of(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
                            const Pose2<Map, Base>& T_map_base, double near_m);

/// 1 for a scan that the map explains, 0 for one that it contradicts: the mean over the points of 1 near a wall, a half
/// in free space that the laser sees through free space (something new may stand there), 0 behind walls or where the map
/// knows nothing. `laser_base`: where the laser is.
[[nodiscard]] double plausibility_of(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
                                     const Eigen::Vector2d& laser_base, const Pose2<Map, Base>& T_map_base,
                                     double near_m);

/// What is known before the scan is looked at: a pose with independent deviations.
struct AlignmentPrior {
  Pose2<Map, Base> T_map_base;
  double sigma_xy_m = 0.05;
  double sigma_yaw_rad = radians(2.0);
};

/// Offsets are x [m], y [m], yaw [rad] in the map's frame.
[[nodiscard]] Pose2<Map, Base> moved(const Pose2<Map, Base>& pose, const Eigen::Vector3d& offset);
[[nodiscard]] Eigen::Vector3d offset_of(const Pose2<Map, Base>& pose, const Pose2<Map, Base>& from);

/// Half the squared distance of a pose that is off the prior by x [m], y [m], yaw [rad], in deviations.
[[nodiscard]] double prior_cost(const AlignmentPrior& prior, const Eigen::Vector3d& offset);

/// Gauss-Newton from the best pose of a window round the prior (scan_search.hpp), with a redescending weight (Geman and
/// McClure): points far from any wall have no say.
[[nodiscard]] Pose2<Map, Base> aligned(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
                                       const AlignmentPrior& prior);

}  // namespace amiss::localize::internal
