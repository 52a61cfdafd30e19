#include "mapping/internal/frame_check.hpp"

#include <cmath>

#include "core/result.hpp"
#include "mapping/voxel_blocks.hpp"

namespace amiss::mapping {

bool reachable(const Eigen::Vector3d& p, double resolution_m) {
  return p.allFinite() && p.cwiseAbs().maxCoeff() / resolution_m < kVoxelLimit - 1;
}

void check_frame(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera, double resolution_m) {
  const CameraIntrinsics& k = frame.intrinsics;
  if (k.width <= 0 || k.height <= 0 ||
      frame.depth_m.size() != static_cast<std::size_t>(k.width) * static_cast<std::size_t>(k.height)) {
    throw InputError("frame: the number of depth pixels must be width x height");
  }
  if (!(k.fx > 0.0 && k.fy > 0.0 && std::isfinite(k.fx + k.fy + k.cx + k.cy))) {
    throw InputError("frame: the focal lengths must be positive and all intrinsics finite");
  }
  if (!T_map_camera.T.matrix().allFinite() || !reachable(T_map_camera.position(), resolution_m)) {
    throw InputError("frame: the camera's pose must be finite and within the map's limits");
  }
}

}  // namespace amiss::mapping
