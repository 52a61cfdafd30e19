// A truncated signed distance field in colour (TSDF; Curless and Levoy 1996, voxblox: Oleynikova et al. 2017; thesis
// 5.3.2.1), with free space carved and told apart from what was never seen.
//
// in: RgbdFrame + T_map_camera     out: for each voxel the signed distance to the surface along the rays [m] (positive
// before it), its weight and colour; and the three values unknown, free, occupied
//
// As in voxblox: a ray counts 1 / z^2 of its end point, less and less from one voxel behind the surface to the
// truncation; rays longer than max_range_m only free space, as far as max_range_m. Unlike voxblox no ray is cast: each
// voxel of a block that the frame can change is projected into the depth image once and takes the weight of all rays
// that cross it. Near the camera, where many pixels fall into a voxel, it looks at their mean.
//
// Blocks of 8 x 8 x 8 voxels in a hash table (voxel_blocks.hpp); those of free space alone keep bits and one weight, so
// a room at 1 cm fits into memory. values() are bit planes: free where the distance is more than a voxel, occupied
// within a voxel of the surface, unknown behind it. Maps are regular values. Errors: ArgumentError for wrong
// parameters, InputError for a frame of sizes that do not fit or a pose that is not finite; the map is then as it was.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/params.hpp"
#include "core/sensors.hpp"
#include "mapping/voxel_blocks.hpp"

namespace amiss::mapping {

struct SurfaceParams {
  double voxel_m = 0.01;           // of Table 5.1
  double truncation_voxels = 4.0;  // distances are cut at so many voxels
  double min_range_m = 0.1;        // of depth that is used
  double max_range_m = 2.0;        // of Table 5.1: the longest ray
  double max_weight = 10000.0;

  [[nodiscard]] double truncation_m() const { return truncation_voxels * voxel_m; }
};
void describe(ParamTable& table, SurfaceParams& params);

/// The voxels of one block near a surface, by index_in_block. Weight 0: not seen.
struct SurfaceVoxels {
  std::array<float, kBlockVoxels> distance_m{};
  std::array<float, kBlockVoxels> weight{};
  std::array<Rgb, kBlockVoxels> colour{};
};

struct SurfaceVoxel {
  float distance_m = 0.0f;
  float weight = 0.0f;
  Rgb colour;
};

/// Between voxel centres.
struct DistanceSample {
  float distance_m = 0.0f;
  Eigen::Vector3f gradient = Eigen::Vector3f::Zero();  // of the distance in the map frame, about a unit vector
};

class SurfaceMap {
 public:
  explicit SurfaceMap(const SurfaceParams& params = {});
  SurfaceMap(const SurfaceMap& other);
  SurfaceMap& operator=(const SurfaceMap& other);
  SurfaceMap(SurfaceMap&&) noexcept;
  SurfaceMap& operator=(SurfaceMap&&) noexcept;
  ~SurfaceMap();

  void insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera);

  [[nodiscard]] const SurfaceParams& params() const { return params_; }
  [[nodiscard]] Voxel voxel_at(const Eigen::Vector3d& p_map) const;  // finite points near the map only
  [[nodiscard]] Eigen::Vector3d centre_of(Voxel v) const;
  [[nodiscard]] Occupancy at(Voxel v) const { return values_.at(v); }
  [[nodiscard]] Occupancy at(const Eigen::Vector3d& p_map) const;  // outside the limits: unknown
  /// Nothing where no ray came by. Free voxels far from all surfaces are at the truncation.
  [[nodiscard]] std::optional<SurfaceVoxel> voxel(Voxel v) const;
  /// Nothing where one of the eight voxels around the point lies in a block without a surface or was not seen.
  [[nodiscard]] std::optional<DistanceSample> sample(const Eigen::Vector3d& p_map) const;

  [[nodiscard]] const VoxelBlocks& values() const { return values_; }
  /// nullptr for a block of free space alone.
  [[nodiscard]] const SurfaceVoxels* surface(std::uint32_t slot) const { return surfaces_[slot].get(); }
  [[nodiscard]] float free_weight(std::uint32_t slot) const { return free_weights_[slot]; }
  [[nodiscard]] std::size_t surface_blocks() const;

 private:
  class Scratch;
  struct Sight;

  std::uint32_t slot_of(BlockKey key);
  SurfaceVoxels& surface_of(std::uint32_t slot);
  void update_values(std::uint32_t slot);
  void look_at_cube(const Sight& sight, BlockKey low, int edge_blocks);
  void free_block(const Sight& sight, BlockKey key);
  void look_at_block(const Sight& sight, BlockKey key);

  SurfaceParams params_;
  VoxelBlocks values_;
  std::vector<float> free_weights_;                       // by slot
  std::vector<std::unique_ptr<SurfaceVoxels>> surfaces_;  // by slot
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace amiss::mapping
