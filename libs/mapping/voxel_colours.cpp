#include "mapping/voxel_colours.hpp"

#include <algorithm>
#include <cmath>

#include "core/result.hpp"
#include "mapping/internal/frame_check.hpp"

namespace amiss::mapping {
namespace {

/// Towards the free voxels among the 26 neighbours; zero where there are none.
Eigen::Vector3f towards_free(const VoxelMap& map, Voxel v) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        if (map.at(Voxel{v.x + x, v.y + y, v.z + z}) != Occupancy::kFree) continue;
        sum += Eigen::Vector3i(x, y, z).cast<float>().normalized();
      }
    }
  }
  return sum;
}

}  // namespace

void VoxelColours::insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera) {
  check_frame(frame, T_map_camera, voxel_m_);
  if (frame.colour.size() != frame.depth_m.size()) {
    throw InputError("frame: colour and depth must have equally many pixels");
  }
  const CameraIntrinsics& k = frame.intrinsics;
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
    const auto z = static_cast<double>(frame.depth_m[i]);
    if (!std::isfinite(z) || z < min_range_m_) continue;
    const std::size_t width = static_cast<std::size_t>(k.width);
    const Eigen::Vector3d p((static_cast<double>(i % width) - k.cx) / k.fx * z,
                            (static_cast<double>(i / width) - k.cy) / k.fy * z, z);
    if (p.norm() > max_range_m_) continue;
    const Eigen::Vector3d v = (T_map_camera.T * p / voxel_m_).array().floor();
    Sum& sum = sums_[{static_cast<int>(v.x()), static_cast<int>(v.y()), static_cast<int>(v.z())}];
    sum.r += frame.colour[i].r;
    sum.g += frame.colour[i].g;
    sum.b += frame.colour[i].b;
    ++sum.n;
  }
}

std::optional<Rgb> VoxelColours::at(Voxel v) const {
  const auto found = sums_.find(v);
  if (found == sums_.end()) return std::nullopt;
  const Sum& s = found->second;
  const auto mean = [&](std::uint64_t sum) { return static_cast<std::uint8_t>((sum + s.n / 2) / s.n); };
  return Rgb{mean(s.r), mean(s.g), mean(s.b)};
}

Cloud<Map> occupied_cloud(const VoxelMap& map, const VoxelColours& colours) {
  Cloud<Map> cloud;
  for (const Voxel& v : map.voxels(Occupancy::kOccupied)) {
    const Eigen::Vector3f normal = towards_free(map, v);
    if (normal.norm() < 1e-3f) continue;
    cloud.points.push_back(map.centre_of(v).cast<float>());
    cloud.colours.push_back(colours.at(v).value_or(Rgb{}));
    cloud.normals.push_back(normal.normalized());
  }
  return cloud;
}

}  // namespace amiss::mapping
