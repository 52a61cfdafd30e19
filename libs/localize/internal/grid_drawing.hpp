// An occupancy grid that is drawn from scans at known poses, as a FloorGrid.
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <optional>

#include "core/floor_grid.hpp"
#include "core/sensors.hpp"

namespace amiss::localize::internal {

/// MRPT's occupancy grid with an update for each scan inserted.
class DrawnGrid {
 public:
  DrawnGrid(double resolution_m, double max_range_m);
  void add(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser, const Pose2<Map, Base>& T_map_base);
  /// What was drawn so far; made anew only after add().
  [[nodiscard]] const FloorGrid& floor();

 private:
  double resolution_m_;
  mrpt::maps::COccupancyGridMap2D grid_;
  std::optional<FloorGrid> floor_;
};

}  // namespace amiss::localize::internal
