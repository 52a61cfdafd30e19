// voxblox's integrators, voxel by voxel and ray by ray, as slow oracles of SurfaceMap: "simple" casts a ray for each
// pixel, "merged" one for all pixels that end in the same voxel. After Oleynikova et al. 2017 and its published
// behaviour; weights 1 / z^2 with drop-off behind the surface, carving, rays beyond the range only free space.
#pragma once

#include <unordered_map>

#include "core/sensors.hpp"
#include "mapping/surface_map.hpp"

namespace amiss::mapping {

class Voxblox {
 public:
  enum class Method { kSimple, kMerged };
  Voxblox(const SurfaceParams& params, Method method) : params_(params), method_(method) {}

  void insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera);

  struct Hash {
    std::size_t operator()(const Voxel& v) const {
      return static_cast<std::size_t>(v.x) * 73856093U ^ static_cast<std::size_t>(v.y) * 19349669U ^
             static_cast<std::size_t>(v.z) * 83492791U;
    }
  };
  [[nodiscard]] const std::unordered_map<Voxel, SurfaceVoxel, Hash>& voxels() const { return voxels_; }

 private:
  struct Ray {
    Eigen::Vector3d end = Eigen::Vector3d::Zero();  // in the map
    double weight = 0.0;
    Eigen::Vector3d colour = Eigen::Vector3d::Zero();
  };
  void cast(const Eigen::Vector3d& origin, const Ray& ray, bool clearing);
  void update(const Eigen::Vector3d& origin, const Ray& ray, Voxel v);

  SurfaceParams params_;
  Method method_;
  std::unordered_map<Voxel, SurfaceVoxel, Hash> voxels_;
};

}  // namespace amiss::mapping
