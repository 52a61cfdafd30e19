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
/// What the object hides of itself behind its upper edge is guessed from how far that edge is from the middle.
[[nodiscard]] Extent extent_of(const std::vector<Eigen::Vector3f>& points_map, const Plane& ground,
                               const Eigen::Vector3d& camera_map);

}  // namespace amiss::segment::internal
