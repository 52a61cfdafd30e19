// What part of the image a cube of voxels can be seen in.
#pragma once

#include <optional>

#include "mapping/internal/depth_pyramid.hpp"
#include "mapping/internal/frustum.hpp"

namespace amiss::mapping {

inline constexpr float kNearPlaneM = 0.05f;  // voxel centres nearer to the camera's plane say nothing

/// Bounds of the voxel centres of a cube: z in the camera [m], and the pixels, with one to spare on all sides.
struct CubeProjection {
  enum class Place { kNowhere, kNear, kSeen } place = Place::kNowhere;  // kNear: too near to be bounded
  float z_low = 0.0f, z_high = 0.0f;
  PixelRect rect;
  bool inside = false;  // all of it, with a pixel to spare
};

/// Cube of edge x edge x edge voxels with its low corner at corner_local.
[[nodiscard]] CubeProjection project_cube(const Frustum& frustum, const Eigen::Vector3f& corner_local, int edge,
                                          int image_width, int image_height);

}  // namespace amiss::mapping
