// A pan-tilt head with numbers like the HSR's: 0.97 m high, the camera a little to the side of the neck.
#pragma once

#include "view/head.hpp"

namespace amiss::view {

inline Head test_head() {
  Head head;
  head.T_base_camera = [](const robot::HeadState& state) {
    Transform<Base, Camera> T;
    T.T.translate(Eigen::Vector3d(0.0, 0.0, 0.95));
    T.T.rotate(Eigen::AngleAxisd(state.pan_rad, Eigen::Vector3d::UnitZ()));
    T.T.rotate(Eigen::AngleAxisd(-state.tilt_rad, Eigen::Vector3d::UnitY()));
    T.T.translate(Eigen::Vector3d(0.03, 0.022, 0.06));
    Eigen::Matrix3d optical;  // columns: the optical axes right, down, ahead
    optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    T.T.rotate(optical);
    return T;
  };
  return head;
}

inline Eigen::Vector2d pixel_of(const Head& head, const Pose2<Map, Base>& T_map_base, const robot::HeadState& state,
                                const Eigen::Vector3d& p_map) {
  const Eigen::Vector3d p = (T_map_base.lift() * head.T_base_camera(state)).inverse().T * p_map;
  return {head.camera.fx * p.x() / p.z() + head.camera.cx, head.camera.fy * p.y() / p.z() + head.camera.cy};
}

}  // namespace amiss::view
