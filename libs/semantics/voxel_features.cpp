#include "semantics/voxel_features.hpp"

#include <array>
#include <cassert>
#include <cmath>

#include "semantics/internal/box_features.hpp"
#include "semantics/internal/moments.hpp"
#include "semantics/parallel.hpp"

namespace amiss::semantics {

namespace {

constexpr std::array<int, 4> kScales{1, 2, 4, 8};  // edges of the cells, in voxels
constexpr std::size_t kOwnFeatures = 7, kShapeFeatures = 13;
static_assert(kOwnFeatures + kScales.size() * kShapeFeatures + BoxFeatures::kCount == kFeatureCount);

/// Normals that the cloud does not tell: of the plane around the voxel, upwards.
void complete_normals(Voxels& voxels, const Surroundings& surroundings) {
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (!voxels.normals[v].isZero()) continue;
    const Eigen::Vector3f& normal = surroundings.at(v).normal;
    voxels.normals[v] = normal.z() < 0 ? Eigen::Vector3f(-normal) : normal;
  }
}

float* put_own(const Voxels& voxels, std::size_t v, float* out) {
  const Eigen::Vector3f &normal = voxels.normals[v], &lab = voxels.colours[v];
  for (const float value : {voxels.positions[v].z(), normal.z(), std::abs(normal.z()), lab.x(), lab.y(), lab.z(),
                            std::hypot(lab.y(), lab.z())}) {
    *out++ = value;
  }
  return out;
}

float* put_shape(const Voxels& voxels, std::size_t v, const Surrounding& s, float window_m, float* out) {
  const Eigen::Vector3f deviations = s.variances.cwiseSqrt();
  const float largest = std::max(deviations[2], 1e-6F);
  const Eigen::Vector3f offset = (s.mean - voxels.positions[v]) / window_m;
  const float edge = static_cast<float>(voxels.edge_m);
  for (const float value :
       {(deviations[2] - deviations[1]) / largest, (deviations[1] - deviations[0]) / largest, deviations[0] / largest,
        deviations[0] / window_m, std::abs(s.normal.z()), std::sqrt(s.variance_z) / window_m, offset.z(),
        offset.dot(voxels.normals[v]), s.voxels * edge * edge / (window_m * window_m), s.colour.x(), s.colour.y(),
        s.colour.z(), s.colour_deviation.sum()}) {
    *out++ = value;
  }
  return out;
}

}  // namespace

VoxelFeatures voxel_features(const Cloud<Map>& cloud, double voxel_m, int threads) {
  VoxelFeatures features;
  features.voxels = voxels_of(cloud, voxel_m);
  Voxels& voxels = features.voxels;
  if (voxels.size() == 0) return features;
  std::vector<Surroundings> scales;
  for (const int scale : kScales) scales.push_back(surroundings_of(voxels, scale * voxel_m, threads));
  complete_normals(voxels, scales[1]);
  const BoxFeatures boxes(voxels);
  features.values.resize(voxels.size() * kFeatureCount);
  in_parallel(voxels.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      float* out = put_own(voxels, v, features.values.data() + v * kFeatureCount);
      for (std::size_t s = 0; s < scales.size(); ++s) {
        out = put_shape(voxels, v, scales[s].at(v), static_cast<float>(3 * kScales[s] * voxel_m), out);
      }
      out = boxes.put(v, out);
      assert(out == features.values.data() + (v + 1) * kFeatureCount);
    }
  });
  return features;
}

}  // namespace amiss::semantics
