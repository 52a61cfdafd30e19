#include "view/head.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::view {
namespace {

constexpr int kRounds = 8;  // of turning until it looks at the point; the camera moves as the head turns

}  // namespace

robot::HeadState look_at(const Head& head, const Pose2<Map, Base>& T_map_base, const Eigen::Vector3d& point_map) {
  const Eigen::Vector3d p_base = T_map_base.lift().inverse().T * point_map;
  // Directions of the middle of the image against the optical axis.
  const double right = std::atan((0.5 * (head.camera.width - 1) - head.camera.cx) / head.camera.fx);
  const double down = std::atan((0.5 * (head.camera.height - 1) - head.camera.cy) / head.camera.fy);
  robot::HeadState state{0.0, std::clamp(-0.5, head.tilt_min_rad, head.tilt_max_rad)};
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Vector3d p = head.T_base_camera(state).inverse().T * p_base;
    state.pan_rad -= std::atan2(p.x(), p.z()) - right;
    state.tilt_rad -= std::atan2(p.y(), p.z()) - down;
    state.tilt_rad = std::clamp(state.tilt_rad, head.tilt_min_rad, head.tilt_max_rad);
  }
  return state;
}

}  // namespace amiss::view
