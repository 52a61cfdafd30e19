#include "mapping/internal/block_projection.hpp"

#include <algorithm>

namespace amiss::mapping {

CubeProjection project_cube(const Frustum& f, const Eigen::Vector3f& corner_local, int edge, int image_width,
                            int image_height) {
  // The outermost centres of the cube; everything between projects between.
  const Eigen::Vector3f first = f.R_camera_local * (corner_local + Eigen::Vector3f::Constant(0.5f)) + f.t_camera_local;
  const Eigen::Matrix3f edges = f.R_camera_local * (static_cast<float>(edge) - 1.0f);
  const Eigen::Vector3f low_edges = edges.cwiseMin(0.0f).rowwise().sum();
  const Eigen::Vector3f high_edges = edges.cwiseMax(0.0f).rowwise().sum();
  CubeProjection cube;
  cube.z_low = first.z() + low_edges.z();
  cube.z_high = first.z() + high_edges.z();
  if (cube.z_high < kNearPlaneM) return cube;
  cube.place = CubeProjection::Place::kNear;
  if (cube.z_low < 2.0f * kNearPlaneM) return cube;
  float u_low = 1e9f, u_high = -1e9f, v_low = 1e9f, v_high = -1e9f;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3f p = first;
    for (int axis = 0; axis < 3; ++axis) {
      if (((corner >> axis) & 1) != 0) p += edges.col(axis);
    }
    const float u = p.x() / p.z() * f.fx + f.cx, v = p.y() / p.z() * f.fy + f.cy;
    u_low = std::min(u_low, u);
    u_high = std::max(u_high, u);
    v_low = std::min(v_low, v);
    v_high = std::max(v_high, v);
  }
  // A pixel to spare on all sides for what rounding may do.
  const auto width = static_cast<float>(image_width), height = static_cast<float>(image_height);
  const bool beside = u_high < -1.5f || v_high < -1.5f || u_low > width + 0.5f || v_low > height + 0.5f;
  cube.place = beside ? CubeProjection::Place::kNowhere : CubeProjection::Place::kSeen;
  cube.inside = u_low >= 1.5f && v_low >= 1.5f && u_high <= width - 2.5f && v_high <= height - 2.5f;
  const auto pixel = [](float at, float limit) { return static_cast<int>(std::clamp(at, 0.0f, limit)); };
  cube.rect = {pixel(u_low - 1.5f, width - 1.0f), pixel(u_high + 1.5f, width - 1.0f),
               pixel(v_low - 1.5f, height - 1.0f), pixel(v_high + 1.5f, height - 1.0f)};
  return cube;
}

}  // namespace amiss::mapping
