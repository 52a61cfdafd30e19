// What a surface map knows of a place.
#include <algorithm>
#include <cmath>

#include "mapping/surface_map.hpp"

namespace amiss::mapping {

Voxel SurfaceMap::voxel_at(const Eigen::Vector3d& p_map) const {
  const Eigen::Vector3d v = (p_map / params_.voxel_m).array().floor();
  return {static_cast<int>(v.x()), static_cast<int>(v.y()), static_cast<int>(v.z())};
}

Eigen::Vector3d SurfaceMap::centre_of(Voxel v) const {
  return (Eigen::Vector3d(v.x, v.y, v.z) + Eigen::Vector3d::Constant(0.5)) * params_.voxel_m;
}

Occupancy SurfaceMap::at(const Eigen::Vector3d& p_map) const {
  const bool inside = p_map.allFinite() && p_map.cwiseAbs().maxCoeff() < (kVoxelLimit - 1) * params_.voxel_m;
  return inside ? values_.at(voxel_at(p_map)) : Occupancy::kUnknown;
}

std::optional<SurfaceVoxel> SurfaceMap::voxel(Voxel v) const {
  const std::uint32_t slot = values_.find(block_of(v));
  if (slot == VoxelBlocks::kNone) return std::nullopt;
  const unsigned i = index_in_block(v);
  if (!surfaces_[slot]) {
    const bool free = ((values_.blocks()[slot].known[i / 64] >> (i % 64)) & 1U) != 0;
    if (!free) return std::nullopt;
    return SurfaceVoxel{static_cast<float>(params_.truncation_m()), free_weights_[slot], {}};
  }
  const SurfaceVoxels& voxels = *surfaces_[slot];
  if (voxels.weight[i] <= 0.0f) return std::nullopt;
  return SurfaceVoxel{voxels.distance_m[i], voxels.weight[i], voxels.colour[i]};
}

std::optional<DistanceSample> SurfaceMap::sample(const Eigen::Vector3d& p_map) const {
  const Eigen::Vector3d at = p_map / params_.voxel_m - Eigen::Vector3d::Constant(0.5);
  const Eigen::Vector3d low = at.array().floor();
  if (!low.allFinite() || low.cwiseAbs().maxCoeff() > kVoxelLimit - 2) return std::nullopt;
  const Eigen::Vector3f t = (at - low).cast<float>();
  const Voxel v{static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(low.z())};
  float d[8];
  BlockKey key{};
  const SurfaceVoxels* voxels = nullptr;
  for (int corner = 0; corner < 8; ++corner) {
    const Voxel at_corner{v.x + (corner & 1), v.y + ((corner >> 1) & 1), v.z + (corner >> 2)};
    const BlockKey wanted = block_of(at_corner);
    if (voxels == nullptr || wanted != key) {
      const std::uint32_t slot = values_.find(wanted);
      if (slot == VoxelBlocks::kNone || !surfaces_[slot]) return std::nullopt;
      voxels = surfaces_[slot].get();
      key = wanted;
    }
    const unsigned i = index_in_block(at_corner);
    if (voxels->weight[i] <= 0.0f) return std::nullopt;
    d[corner] = voxels->distance_m[i];
  }
  const auto mix = [](float a, float b, float part) { return a + (b - a) * part; };
  const float x00 = mix(d[0], d[1], t.x()), x10 = mix(d[2], d[3], t.x());
  const float x01 = mix(d[4], d[5], t.x()), x11 = mix(d[6], d[7], t.x());
  const float y0 = mix(x00, x10, t.y()), y1 = mix(x01, x11, t.y());
  DistanceSample sample;
  sample.distance_m = mix(y0, y1, t.z());
  const float dx = mix(mix(d[1] - d[0], d[3] - d[2], t.y()), mix(d[5] - d[4], d[7] - d[6], t.y()), t.z());
  sample.gradient =
      Eigen::Vector3f(dx, mix(x10 - x00, x11 - x01, t.z()), y1 - y0) / static_cast<float>(params_.voxel_m);
  return sample;
}

std::size_t SurfaceMap::surface_blocks() const {
  return static_cast<std::size_t>(
      std::count_if(surfaces_.begin(), surfaces_.end(), [](const auto& s) { return s != nullptr; }));
}

}  // namespace amiss::mapping
