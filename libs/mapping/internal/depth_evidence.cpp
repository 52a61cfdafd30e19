#include "mapping/internal/depth_evidence.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/internal/block_projection.hpp"
#include "mapping/internal/wide.hpp"

namespace amiss::mapping {
namespace {

constexpr float kNearM = kNearPlaneM;

struct Image {
  const float* reach;
  std::int32_t width, height;
  float fx, fy, cx, cy;
};
/// Centres of a block's voxels in the camera frame: first + x a + y b + z c.
struct Lattice {
  float first[3], a[3], b[3], c[3];
};

/// Bit 8 y + x of layer z: the ray through the voxel's centre reaches beyond it.
AMISS_WIDE void missed_voxels(Image image, const Lattice& l, std::uint64_t* missed) {
  constexpr float kBeyond = 3.0e38f;
  const auto width = static_cast<float>(image.width), height = static_cast<float>(image.height);
  for (int z = 0; z < kBlockEdge; ++z) {
    std::uint64_t word = 0;
    for (int y = 0; y < kBlockEdge; ++y) {
      float depth[kBlockEdge];
      std::int32_t pixel[kBlockEdge];
      const auto fy = static_cast<float>(y), fz = static_cast<float>(z);
      const float px = l.first[0] + fy * l.b[0] + fz * l.c[0];
      const float py = l.first[1] + fy * l.b[1] + fz * l.c[1];
      const float pz = l.first[2] + fy * l.b[2] + fz * l.c[2];
      for (int x = 0; x < kBlockEdge; ++x) {
        const auto f = static_cast<float>(x);
        const float d = pz + f * l.a[2];
        const float inverse = 1.0f / std::max(d, kNearM);
        const float u = (px + f * l.a[0]) * inverse * image.fx + (image.cx + 0.5f);
        const float v = (py + f * l.a[1]) * inverse * image.fy + (image.cy + 0.5f);
        const auto yes = [](bool b) { return static_cast<std::int32_t>(b); };
        const std::int32_t inside =
            yes(d >= kNearM) & yes(u >= 0.0f) & yes(v >= 0.0f) & yes(u < width) & yes(v < height);
        const auto column = static_cast<std::int32_t>(std::min(std::max(u, 0.0f), width - 1.0f));
        const auto row = static_cast<std::int32_t>(std::min(std::max(v, 0.0f), height - 1.0f));
        pixel[x] = row * image.width + column;
        depth[x] = inside != 0 ? d : kBeyond;
      }
      std::uint64_t bits = 0;
      for (int x = 0; x < kBlockEdge; ++x) {
        bits |= static_cast<std::uint64_t>(image.reach[pixel[x]] > depth[x] ? 1u : 0u) << x;
      }
      word |= bits << (8 * y);
    }
    missed[z] = word;
  }
}

}  // namespace

const std::vector<BlockEvidence>& DepthEvidence::look(const RgbdFrame& frame,
                                                      const Transform<Map, Camera>& T_map_camera,
                                                      const VoxelMapParams& params, Search search) {
  frustum_ = frustum_of(frame.intrinsics, T_map_camera, params);
  pyramid_.build(frame, params);
  end_points_.count(frame, frustum_, params);
  evidence_.clear();
  for (int z = 0; z < frustum_.nz; ++z) {
    for (int y = 0; y < frustum_.ny; ++y) {
      for (int x = 0; x < frustum_.nx; ++x) add_block(x, y, z, params, search);
    }
  }
  return evidence_;
}

DepthEvidence::Verdict DepthEvidence::judge(const Eigen::Vector3f& corner_local) const {
  const CubeProjection cube = project_cube(frustum_, corner_local, kBlockEdge, pyramid_.width(), pyramid_.height());
  if (cube.place == CubeProjection::Place::kNowhere) return Verdict::kNothing;
  if (cube.place == CubeProjection::Place::kNear) return Verdict::kMixed;
  const DepthPyramid::Range reach = pyramid_.range(cube.rect);
  constexpr float kSpareM = 1e-4f;
  if (reach.high <= cube.z_low - kSpareM) return Verdict::kNothing;
  return cube.inside && reach.low > cube.z_high + kSpareM ? Verdict::kAllMissed : Verdict::kMixed;
}

void DepthEvidence::add_block(int x, int y, int z, const VoxelMapParams& params, Search search) {
  const Eigen::Vector3f corner(static_cast<float>(kBlockEdge * x), static_cast<float>(kBlockEdge * y),
                               static_cast<float>(kBlockEdge * z));
  const Verdict verdict = search == Search::kPyramid ? judge(corner) : Verdict::kMixed;
  const std::size_t index = frustum_.index(x, y, z);
  const bool ends = end_points_.any(index);
  if (verdict == Verdict::kNothing && !ends) return;
  BlockEvidence evidence{{frustum_.low.x + x, frustum_.low.y + y, frustum_.low.z + z}, {}, {}};
  if (verdict == Verdict::kAllMissed) evidence.miss.fill(~std::uint64_t{0});
  if (verdict == Verdict::kMixed) {
    const Eigen::Matrix3f& R = frustum_.R_camera_local;
    const Eigen::Vector3f first = R * (corner + Eigen::Vector3f::Constant(0.5f)) + frustum_.t_camera_local;
    Lattice lattice{};
    for (int k = 0; k < 3; ++k) {
      lattice.first[k] = first[k];
      lattice.a[k] = R(k, 0);
      lattice.b[k] = R(k, 1);
      lattice.c[k] = R(k, 2);
    }
    const Image image{pyramid_.reach(), pyramid_.width(), pyramid_.height(), frustum_.fx,
                      frustum_.fy,      frustum_.cx,      frustum_.cy};
    missed_voxels(image, lattice, evidence.miss.data());
  }
  if (ends) {
    const EndPoints::Verdict end = end_points_.verdict(index, corner, frustum_, params);
    for (std::size_t l = 0; l < kBlockEdge; ++l) {
      evidence.hit[l] = end.hit[l];
      evidence.miss[l] &= ~(end.hit[l] | end.doubtful[l]);
    }
  }
  if (!evidence.empty()) evidence_.push_back(evidence);
}

}  // namespace amiss::mapping
