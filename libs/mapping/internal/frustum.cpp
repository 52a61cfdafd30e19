#include "mapping/internal/frustum.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::mapping {

Frustum frustum_of(const CameraIntrinsics& camera, const Transform<Map, Camera>& T_map_camera,
                   const VoxelMapParams& params) {
  const double far_m = std::max(params.max_range_m, params.max_hit_range_m);
  const double voxel = params.resolution_m;
  Eigen::Vector3d low = T_map_camera.position(), high = low;
  for (int corner = 0; corner < 4; ++corner) {
    const double u = (corner & 1) != 0 ? camera.width - 0.5 : -0.5, v = (corner & 2) != 0 ? camera.height - 0.5 : -0.5;
    const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
    const Eigen::Vector3d p = T_map_camera.T * Eigen::Vector3d(far_m * ray);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto block = [&](double metres, double spare_voxels) {
    return static_cast<int>(std::floor((metres / voxel + spare_voxels) / kBlockEdge));
  };
  Frustum f;
  f.low = {block(low.x(), -1.0), block(low.y(), -1.0), block(low.z(), -1.0)};
  f.nx = block(high.x(), 1.0) - f.low.x + 1;
  f.ny = block(high.y(), 1.0) - f.low.y + 1;
  f.nz = block(high.z(), 1.0) - f.low.z + 1;
  const Eigen::Vector3d corner = Eigen::Vector3d(f.low.x, f.low.y, f.low.z) * (kBlockEdge * voxel);
  const Eigen::Matrix3d R = T_map_camera.T.linear();
  f.R_local_camera = (R / voxel).cast<float>();
  f.t_local_camera = ((T_map_camera.position() - corner) / voxel).cast<float>();
  f.R_camera_local = (R.transpose() * voxel).cast<float>();
  f.t_camera_local = (R.transpose() * (corner - T_map_camera.position())).cast<float>();
  const double step = params.pixel_step;
  f.fx = static_cast<float>(camera.fx / step);
  f.fy = static_cast<float>(camera.fy / step);
  f.cx = static_cast<float>(camera.cx / step);
  f.cy = static_cast<float>(camera.cy / step);
  return f;
}

}  // namespace amiss::mapping
