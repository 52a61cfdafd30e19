// Which batches of which bodies a camera needs, in the order in which they are drawn: solid ones from near to far, so
// that what is hidden costs little, then transparent ones from far to near.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "sim/internal/gpu_scene.hpp"
#include "sim/renderer.hpp"

namespace amiss::sim::internal {

struct DrawCall {
  std::size_t body;
  const GpuBatch* batch;
  float
      distance_m;  // of the farthest place that its box may reach: walls and floors come after what stands before them
};

/// T_camera_bodies holds one transform for each body. With options.cull only what the frustum touches.
[[nodiscard]] std::vector<DrawCall> draw_list(const std::vector<GpuBody>& bodies,
                                              std::span<const Eigen::Isometry3f> T_camera_bodies,
                                              const CameraIntrinsics& intrinsics, const RenderOptions& options);

}  // namespace amiss::sim::internal
