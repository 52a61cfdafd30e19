// Simultaneous localization and mapping in the plane: laser and odometry -> poses and a floor grid. MRPT's ICP (CICP)
// on its point map finds the neighbourhood, point-to-line alignment the pose; MRPT's occupancy grid is drawn from key
// scans. The map frame is the robot's pose at the first update. Poses in metres and radians; grid() has the parameter's
// resolution, 0.05 m as a rule.
// Errors: ArgumentError for parameters that contradict each other. Scans without a return are skipped.
#pragma once

#include <memory>

#include "core/floor_grid.hpp"
#include "core/params.hpp"
#include "core/sensors.hpp"

namespace amiss::localize {

struct LaserMapperParams {
  double resolution_m = 0.05;            // of grid()
  double key_distance_m = 0.25;          // driven between two scans that are kept
  double key_angle_rad = radians(10.0);  // turned between two scans that are kept
  double point_distance_m = 0.02;        // between two points of the point map
  double min_goodness = 0.6;             // part of the points that ICP must match, else odometry alone is believed
  double max_range_m = 12.0;             // of the beams that free the grid
};
void describe(ParamTable& table, LaserMapperParams& p);

class LaserMapper {
 public:
  explicit LaserMapper(const LaserMapperParams& params);
  ~LaserMapper();
  LaserMapper(LaserMapper&&) noexcept;
  LaserMapper& operator=(LaserMapper&&) noexcept;

  /// Stamps must not go back; the scan was taken at the odometry's stamp.
  PoseEstimate update(const Odometry& odometry, const LaserScan& scan, const Transform<Base, Laser>& T_base_laser);

  [[nodiscard]] const PoseEstimate& estimate() const;
  [[nodiscard]] Pose2<Map, Odom> T_map_odom() const;

  /// The map so far: what beams crossed is free, where they ended occupied, the rest unknown. Costs milliseconds where
  /// scans were kept since the last call.
  [[nodiscard]] const FloorGrid& grid();

  /// The map at the end: single occupied cells and free cells that only stray rays reached are taken back. The robot
  /// came from the map's origin, so all that it can reach hangs together with the floor there.
  [[nodiscard]] FloorGrid cleaned_grid();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Takes back what single stray beams left: occupied cells without an occupied neighbour that stand in free space, and
/// free cells that are not reached through free cells from those that a robot at `reachable_from_map` covers.
[[nodiscard]] FloorGrid cleaned(const FloorGrid& grid, const Eigen::Vector2d& reachable_from_map);

}  // namespace amiss::localize
