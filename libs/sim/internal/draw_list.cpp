#include "sim/internal/draw_list.hpp"

#include <algorithm>
#include <array>

namespace amiss::sim::internal {
namespace {

struct HalfSpace {
  Eigen::Vector3f normal;  // points inwards
  float offset;            // inside: normal . p >= offset
};

using Frustum = std::array<HalfSpace, 6>;

Frustum frustum_of(const CameraIntrinsics& c, const RenderOptions& options) {
  const auto left = static_cast<float>((-0.5 - c.cx) / c.fx), right = static_cast<float>((c.width - 0.5 - c.cx) / c.fx);
  const auto top = static_cast<float>((-0.5 - c.cy) / c.fy), low = static_cast<float>((c.height - 0.5 - c.cy) / c.fy);
  return {{{{1, 0, -left}, 0},
           {{-1, 0, right}, 0},
           {{0, 1, -top}, 0},
           {{0, -1, low}, 0},
           {{0, 0, 1}, static_cast<float>(options.near_m)},
           {{0, 0, -1}, static_cast<float>(-options.far_m)}}};
}

bool touches(const Frustum& frustum, const Eigen::Isometry3f& T, const Eigen::AlignedBox3f& box) {
  const Eigen::Vector3f middle = T * box.center(), half = box.sizes() / 2.0F;
  return std::all_of(frustum.begin(), frustum.end(), [&](const HalfSpace& side) {
    const float reach = (T.linear().transpose() * side.normal).cwiseAbs().dot(half);
    return side.normal.dot(middle) + reach >= side.offset;
  });
}

bool draw_before(const DrawCall& a, const DrawCall& b) {
  if (a.batch->transparent != b.batch->transparent) return b.batch->transparent;
  return a.batch->transparent ? a.distance_m > b.distance_m : a.distance_m < b.distance_m;
}

}  // namespace

std::vector<DrawCall> draw_list(const std::vector<GpuBody>& bodies, std::span<const Eigen::Isometry3f> T_camera_bodies,
                                const CameraIntrinsics& intrinsics, const RenderOptions& options) {
  const Frustum frustum = frustum_of(intrinsics, options);
  std::vector<bool> hidden(bodies.size(), false);
  for (const std::size_t body : options.hidden)
    if (body < hidden.size()) hidden[body] = true;
  std::vector<DrawCall> calls;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (hidden[body]) continue;
    const Eigen::Isometry3f& T = T_camera_bodies[body];
    for (const GpuBatch& batch : bodies[body].batches)
      if (!options.cull || touches(frustum, T, batch.box))
        calls.push_back({body, &batch, (T * batch.box.center()).norm() + batch.box.sizes().norm() / 2.0F});
  }
  std::stable_sort(calls.begin(), calls.end(), draw_before);
  return calls;
}

}  // namespace amiss::sim::internal
