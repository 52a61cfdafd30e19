// Our scans, grids and poses as MRPT's.
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose2D.h>

#include "core/floor_grid.hpp"
#include "core/sensors.hpp"

namespace amiss::localize::internal {

template <class To, class From>
[[nodiscard]] mrpt::poses::CPose2D to_mrpt(const Pose2<To, From>& pose) {
  return {pose.x_m, pose.y_m, pose.yaw_rad};
}
template <class To, class From>
[[nodiscard]] Pose2<To, From> pose_from_mrpt(const mrpt::poses::CPose2D& pose) {
  return {pose.x(), pose.y(), wrap_angle(pose.phi())};
}

/// Is range i one that the laser measured?
[[nodiscard]] bool valid_range(const LaserScan& scan, std::size_t i);

/// At most max_beams beams, evenly taken. Invalid where nothing came back.
[[nodiscard]] mrpt::obs::CObservation2DRangeScan::Ptr to_mrpt(const LaserScan& scan,
                                                              const Transform<Base, Laser>& T_base_laser,
                                                              int max_beams);

/// Lower left corner at (0, 0): MRPT rounds corners to multiples of the resolution, which would shift other origins.
[[nodiscard]] mrpt::maps::COccupancyGridMap2D::Ptr to_mrpt(const FloorGrid& grid);

}  // namespace amiss::localize::internal
