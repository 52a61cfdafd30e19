// The colours of an occupancy map, which itself has none: the mean colour of the depth pixels that end in each voxel;
// and the map's surface as points, for those who want a reconstruction made of voxels (5.3.6).
//
// in: frames with poses     out: a colour for a voxel; Cloud<Map> with the centre of each occupied voxel that is beside
// a free one, its colour and a normal towards the free side. Sorted by voxel.
#pragma once

#include <optional>
#include <unordered_map>

#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

class VoxelColours {
 public:
  /// Pixels whose ray is longer than max_range_m or whose depth is less than min_range_m do not count.
  VoxelColours(double voxel_m, double min_range_m, double max_range_m)
      : voxel_m_(voxel_m), min_range_m_(min_range_m), max_range_m_(max_range_m) {}

  /// InputError as VoxelMap::insert, and when there are not as many colours as depths.
  void insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera);
  [[nodiscard]] std::optional<Rgb> at(Voxel v) const;

 private:
  struct Sum {
    std::uint64_t r = 0, g = 0, b = 0, n = 0;
  };
  struct Hash {
    std::size_t operator()(const Voxel& v) const {
      return static_cast<std::size_t>(v.x) * 73856093U ^ static_cast<std::size_t>(v.y) * 19349669U ^
             static_cast<std::size_t>(v.z) * 83492791U;
    }
  };
  double voxel_m_, min_range_m_, max_range_m_;
  std::unordered_map<Voxel, Sum, Hash> sums_;
};

[[nodiscard]] Cloud<Map> occupied_cloud(const VoxelMap& map, const VoxelColours& colours);

}  // namespace amiss::mapping
