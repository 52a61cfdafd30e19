#include "mapping/voxblox.hpp"

#include <cmath>
#include <limits>
#include <map>

namespace amiss::mapping {

void Voxblox::update(const Eigen::Vector3d& origin, const Ray& ray, Voxel v) {
  const double voxel = params_.voxel_m, truncation = params_.truncation_m();
  const Eigen::Vector3d centre = (Eigen::Vector3d(v.x, v.y, v.z) + Eigen::Vector3d::Constant(0.5)) * voxel;
  const Eigen::Vector3d whole = ray.end - origin;
  const double sdf = whole.norm() - (centre - origin).dot(whole) / whole.norm();
  double weight = ray.weight;
  if (sdf < -voxel) weight = std::max(weight * (truncation + sdf) / (truncation - voxel), 0.0);
  SurfaceVoxel& at = voxels_[v];
  const double sum = static_cast<double>(at.weight) + weight;
  if (sum < 1e-12) return;
  const double mean = (static_cast<double>(at.distance_m) * static_cast<double>(at.weight) + sdf * weight) / sum;
  if (std::abs(sdf) < truncation) {
    const auto mixed = [&](std::uint8_t old, double seen) {
      return static_cast<std::uint8_t>(
          std::round((static_cast<double>(old) * static_cast<double>(at.weight) + seen * weight) / sum));
    };
    at.colour = {mixed(at.colour.r, ray.colour.x()), mixed(at.colour.g, ray.colour.y()),
                 mixed(at.colour.b, ray.colour.z())};
  }
  at.distance_m = static_cast<float>(std::clamp(mean, -truncation, truncation));
  at.weight = static_cast<float>(std::min(sum, params_.max_weight));
}

void Voxblox::cast(const Eigen::Vector3d& origin, const Ray& ray, bool clearing) {
  const double truncation = params_.truncation_m();
  const Eigen::Vector3d direction = (ray.end - origin).normalized();
  const double length = (ray.end - origin).norm();
  const Eigen::Vector3d end =
      clearing ? Eigen::Vector3d(origin + direction * std::min(std::max(length - truncation, 0.0), params_.max_range_m))
               : Eigen::Vector3d(ray.end + direction * truncation);
  // Amanatides and Woo 1987, from the origin (carving).
  const Eigen::Vector3d from = origin / params_.voxel_m, to = end / params_.voxel_m;
  const auto cell = [](const Eigen::Vector3d& p) {
    return Voxel{static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())),
                 static_cast<int>(std::floor(p.z()))};
  };
  Voxel v = cell(from);
  const Voxel last = cell(to);
  int* const at[3] = {&v.x, &v.y, &v.z};
  int step[3];
  double next[3], delta[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double way = to[axis] - from[axis];
    step[axis] = way > 0.0 ? 1 : -1;
    delta[axis] = way != 0.0 ? 1.0 / std::abs(way) : std::numeric_limits<double>::infinity();
    const double border = std::floor(from[axis]) + (way > 0.0 ? 1.0 : 0.0);
    next[axis] = way != 0.0 ? (border - from[axis]) / way : std::numeric_limits<double>::infinity();
  }
  const int steps = std::abs(last.x - v.x) + std::abs(last.y - v.y) + std::abs(last.z - v.z);
  for (int i = 0; i <= steps; ++i) {
    update(origin, ray, v);
    const int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    *at[axis] += step[axis];
    next[axis] += delta[axis];
  }
}

void Voxblox::insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera) {
  const CameraIntrinsics& k = frame.intrinsics;
  const Eigen::Vector3d origin = T_map_camera.position();
  std::map<Voxel, Ray> merged;
  for (int v = 0; v < k.height; ++v) {
    for (int u = 0; u < k.width; ++u) {
      const std::size_t pixel =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(k.width) + static_cast<std::size_t>(u);
      const auto z = static_cast<double>(frame.depth_m[pixel]);
      if (!std::isfinite(z) || z < params_.min_range_m) continue;
      const Rgb c = frame.colour[pixel];
      const Eigen::Vector3d p_camera((u - k.cx) / k.fx * z, (v - k.cy) / k.fy * z, z);
      Ray ray{T_map_camera.T * p_camera, 1.0 / (z * z), Eigen::Vector3d(c.r, c.g, c.b)};
      const bool clearing = p_camera.norm() > params_.max_range_m;
      if (method_ == Method::kSimple || clearing) {
        cast(origin, ray, clearing);
        continue;
      }
      const Eigen::Vector3d cell = (ray.end / params_.voxel_m).array().floor();
      Ray& sum = merged[{static_cast<int>(cell.x()), static_cast<int>(cell.y()), static_cast<int>(cell.z())}];
      const double total = sum.weight + ray.weight;
      sum.end = (sum.end * sum.weight + ray.end * ray.weight) / total;
      sum.colour = (sum.colour * sum.weight + ray.colour * ray.weight) / total;
      sum.weight = total;
    }
  }
  for (const auto& [cell, ray] : merged) cast(origin, ray, false);
}

}  // namespace amiss::mapping
