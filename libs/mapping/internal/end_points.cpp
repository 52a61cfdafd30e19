#include "mapping/internal/end_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mapping/internal/depth_pyramid.hpp"
#include "mapping/internal/wide.hpp"

namespace amiss::mapping {
namespace {

/// A pixel (i, row) with depth d ends at d * (i * along + across) + origin in local voxels.
struct RowGeometry {
  float along[3], across[3], origin[3];
  float min_depth, max_depth;
  std::int32_t nx, ny;
};

AMISS_WIDE void voxels_of_row(const float* depth, std::size_t n, RowGeometry g, std::int32_t* out) {
  for (std::size_t i = 0; i < n; ++i) {
    const float d = depth[i];
    const std::int32_t good = static_cast<std::int32_t>(d >= g.min_depth) & static_cast<std::int32_t>(d <= g.max_depth);
    const float used = good != 0 ? d : 0.0f;
    const auto u = static_cast<float>(static_cast<std::int32_t>(i));
    const auto x = static_cast<std::int32_t>(used * (u * g.along[0] + g.across[0]) + g.origin[0]);
    const auto y = static_cast<std::int32_t>(used * (u * g.along[1] + g.across[1]) + g.origin[1]);
    const auto z = static_cast<std::int32_t>(used * (u * g.along[2] + g.across[2]) + g.origin[2]);
    const std::int32_t block = ((z >> 3) * g.ny + (y >> 3)) * g.nx + (x >> 3);
    const std::int32_t voxel = block * kBlockVoxels + ((z & 7) << 6) + ((y & 7) << 3) + (x & 7);
    out[i] = voxel | (good - 1);
  }
}

/// End points a voxel at depth z needs: a share of the pixels that its face covers. The share grows with the square of
/// the distance beyond 2 m, as the noise of the depth does.
float needed_end_points(float z, const Frustum& f, const VoxelMapParams& params) {
  constexpr float kNearM = 2.0f;
  const auto voxel = static_cast<float>(params.resolution_m);
  const float at = std::max(z, static_cast<float>(params.min_range_m));
  const float pixels = (voxel * f.fx / at) * (voxel * f.fy / at);
  const float growth = std::max(1.0f, (at / kNearM) * (at / kNearM));
  return std::max(static_cast<float>(params.min_end_points),
                  static_cast<float>(params.min_end_fraction) * growth * pixels);
}

}  // namespace

void EndPoints::count(const RgbdFrame& frame, const Frustum& frustum, const VoxelMapParams& params) {
  directory_.assign(frustum.blocks(), -1);
  slots_ = 0;
  const auto step = static_cast<std::size_t>(params.pixel_step);
  const auto width = static_cast<std::size_t>(frame.intrinsics.width);
  const std::size_t n = (width + step - 1) / step;
  row_.resize(n);
  RowGeometry g{};
  g.min_depth = static_cast<float>(params.min_range_m);
  g.max_depth = static_cast<float>(params.max_hit_range_m);
  g.nx = frustum.nx;
  g.ny = frustum.ny;
  const Eigen::Matrix3f& R = frustum.R_local_camera;
  for (std::size_t v = 0; v * step < static_cast<std::size_t>(frame.intrinsics.height); ++v) {
    const float y = (static_cast<float>(v) - frustum.cy) / frustum.fy;
    for (int k = 0; k < 3; ++k) {
      g.along[k] = R(k, 0) / frustum.fx;
      g.across[k] = R(k, 1) * y + R(k, 2) - R(k, 0) * frustum.cx / frustum.fx;
      g.origin[k] = frustum.t_local_camera[k];
    }
    voxels_of_row(sampled_row(frame, step, v, packed_), n, g, row_.data());
    scatter();
  }
}

void EndPoints::scatter() {
  for (const std::int32_t voxel : row_) {
    if (voxel < 0) continue;
    std::int32_t& slot = directory_[static_cast<std::size_t>(voxel) / kBlockVoxels];
    if (slot < 0) {
      slot = slots_++;
      const std::size_t from = static_cast<std::size_t>(slot) * kBlockVoxels;
      if (counts_.size() < from + kBlockVoxels) counts_.resize(2 * (from + kBlockVoxels));
      std::fill_n(counts_.begin() + static_cast<std::ptrdiff_t>(from), kBlockVoxels, std::uint16_t{0});
    }
    std::uint16_t& count =
        counts_[static_cast<std::size_t>(slot) * kBlockVoxels + static_cast<std::size_t>(voxel) % kBlockVoxels];
    if (count != 0xffff) ++count;
  }
}

EndPoints::Verdict EndPoints::verdict(std::size_t block, const Eigen::Vector3f& corner_local, const Frustum& frustum,
                                      const VoxelMapParams& params) const {
  Verdict verdict;
  const std::uint16_t* counts = &counts_[static_cast<std::size_t>(directory_[block]) * kBlockVoxels];
  const auto depth_row = frustum.R_camera_local.row(2);
  for (std::size_t row = 0; row < kBlockEdge * kBlockEdge; ++row) {
    std::uint64_t halves[2];
    std::memcpy(halves, counts + row * kBlockEdge, sizeof halves);
    if ((halves[0] | halves[1]) == 0) continue;
    const std::size_t layer = row / kBlockEdge, y = row % kBlockEdge;
    for (std::size_t x = 0; x < kBlockEdge; ++x) {
      const std::uint16_t count = counts[row * kBlockEdge + x];
      if (count == 0) continue;
      const Eigen::Vector3f centre =
          corner_local +
          Eigen::Vector3f(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, static_cast<float>(layer) + 0.5f);
      const float needed = needed_end_points(depth_row.dot(centre) + frustum.t_camera_local.z(), frustum, params);
      const std::uint64_t bit = std::uint64_t{1} << (y * kBlockEdge + x);
      if (static_cast<float>(count) >= needed) {
        verdict.hit[layer] |= bit;
      } else if (2.0f * static_cast<float>(count) >= needed) {
        verdict.doubtful[layer] |= bit;
      }
    }
  }
  return verdict;
}

}  // namespace amiss::mapping
