// The camera on its pan-tilt head: where it looks for a state of the head, and the state that makes it look at a point.
// Angles in radians, points in the map frame [m].
#pragma once

#include <functional>

#include "core/sensors.hpp"
#include "robot/robot.hpp"

namespace amiss::view {

struct Head {
  CameraIntrinsics camera;
  double tilt_min_rad = -1.57, tilt_max_rad = 0.52;
  std::function<Transform<Base, Camera>(const robot::HeadState&)> T_base_camera;
};

/// The model must outlive the head.
[[nodiscard]] Head head_of(const robot::Model& model);

/// Pan and tilt for the point in the middle of the image from where the base stands; the tilt is clamped to its limits.
[[nodiscard]] robot::HeadState look_at(const Head& head, const Pose2<Map, Base>& T_map_base,
                                       const Eigen::Vector3d& point_map);

}  // namespace amiss::view
