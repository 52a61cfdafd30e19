// The box of blocks that a frame can touch, and the pinhole camera in its coordinates.
#pragma once

#include <Eigen/Geometry>

#include "core/sensors.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

/// Blocks low .. low + (nx, ny, nz) - 1. "Local" coordinates are voxels from the low corner.
struct Frustum {
  BlockKey low;
  int nx = 0, ny = 0, nz = 0;
  Eigen::Matrix3f R_local_camera;  // camera metres -> local voxels
  Eigen::Vector3f t_local_camera;
  Eigen::Matrix3f R_camera_local;  // local voxels -> camera metres
  Eigen::Vector3f t_camera_local;
  float fx, fy, cx, cy;  // of the image of every pixel_step-th pixel

  [[nodiscard]] std::size_t blocks() const {
    return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz);
  }
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(nx) +
           static_cast<std::size_t>(x);
  }
};

/// The frustum of the frame's camera up to max_range_m (and max_hit_range_m), with a voxel to spare on all sides.
[[nodiscard]] Frustum frustum_of(const CameraIntrinsics& camera, const Transform<Map, Camera>& T_map_camera,
                                 const VoxelMapParams& params);

}  // namespace amiss::mapping
