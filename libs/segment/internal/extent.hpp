// The upright box of an object of which one side was seen.
#pragma once

#include <vector>

#include "segment/segment.hpp"

namespace amiss::segment::internal {

struct Extent {
  Eigen::Vector3d centre_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // length, width, height
  double yaw_rad = 0.0;                              // of the length, in (-pi/2, pi/2]
};

/// Smallest upright rectangle round the footprint, a hundredth of the points apart (noise); from the ground to the top.
/// From above, the upper edge of a thing shows how far its unseen back reaches: for a ball of radius r seen 45 degrees
/// from above the middle is 0.15 r too near, for a box it is right.
[[nodiscard]] Extent extent_of(const std::vector<Eigen::Vector3f>& points_map, const Plane& ground);

}  // namespace amiss::segment::internal
