// A map of the room in voxels with three values: unknown, free, occupied (thesis 4.2.1, 4.2.4; Hornung et al. 2013).
//
// in:  RgbdFrame + T_map_camera (or rays: a Cloud<Map> + origin)     out: Occupancy of a point or voxel, and what
// changed
//
// A frame says of a voxel: hit, when enough of the depth pixels that can see it end in it; missed, when the ray through
// its centre ends behind it; nothing otherwise. Pixels without depth say nothing. What frames say adds up as log-odds
// with clamping, as in OctoMap. Pixels deeper than max_hit_range_m free the space before them, no further than
// max_range_m, and hit nothing, since the noise of the depth grows with its square.
//
// Two stores give the same answers: "blocks" (8 x 8 x 8 voxels, two bytes of log-odds each, the fast one) and "octomap"
// (liboctomap's OcTree). Maps are regular values: copies are independent. Errors: ArgumentError for wrong parameters;
// frames with sizes that do not fit, or a pose that is not finite, throw InputError and leave the map as it was.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/frames.hpp"
#include "core/params.hpp"
#include "core/sensors.hpp"
#include "mapping/voxel_blocks.hpp"

namespace amiss::mapping {

struct VoxelMapParams {
  std::string store = "blocks";
  double resolution_m = 0.05;
  double min_range_m = 0.3;
  double max_range_m = 3.0;
  double max_hit_range_m = 2.8;
  int pixel_step = 1;
  int min_end_points = 4;
  double min_end_fraction = 0.05;
  double hit_log_odds = 0.85;
  double miss_log_odds = -0.4;
  double clamp_low = -2.0;
  double clamp_high = 3.5;
};
void describe(ParamTable& table, VoxelMapParams& params);

struct VoxelCounts {
  std::size_t free = 0, occupied = 0;
  bool operator==(const VoxelCounts&) const = default;
};

/// Voxels low.x .. high.x and so on, both ends included.
struct VoxelBox {
  Voxel low, high;
  bool operator==(const VoxelBox&) const = default;
};

class VoxelMap {
 public:
  explicit VoxelMap(const VoxelMapParams& params = {});
  VoxelMap(const VoxelMap& other);
  VoxelMap& operator=(const VoxelMap& other);
  VoxelMap(VoxelMap&&) noexcept;
  VoxelMap& operator=(VoxelMap&&) noexcept;
  ~VoxelMap();

  void insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera);
  /// One ray for each point, as OctoMap's insertPointCloud does it without limits of range: any end point hits, every
  /// voxel a ray crosses is missed unless it is hit. Slow; for foreign clouds and as an oracle.
  void insert(const Cloud<Map>& points, const Point<Map>& origin);

  [[nodiscard]] Occupancy at(const Eigen::Vector3d& p_map) const;  // outside the limits: unknown
  [[nodiscard]] Occupancy at(Voxel v) const { return values_.at(v); }
  void set(Voxel v, Occupancy value);            // occupied, free: clamped log-odds; v within the limits
  void set_log_odds(Voxel v, double log_odds);   // clamped; occupied where >= 0
  [[nodiscard]] double log_odds(Voxel v) const;  // 0 where unknown
  [[nodiscard]] int hit_frames(Voxel v) const;   // frames that hit it since it was unknown, at most 255: the evidence

  [[nodiscard]] double resolution_m() const { return params_.resolution_m; }
  [[nodiscard]] const VoxelMapParams& params() const { return params_; }
  [[nodiscard]] Voxel voxel_at(const Eigen::Vector3d& p_map) const;  // finite points near the map only
  [[nodiscard]] Eigen::Vector3d centre_of(Voxel v) const;

  /// Bit planes of all values, for those who work on whole blocks.
  [[nodiscard]] const VoxelBlocks& values() const { return values_; }
  [[nodiscard]] VoxelCounts counts() const;
  [[nodiscard]] std::optional<VoxelBox> bounds() const;            // of the known voxels
  [[nodiscard]] std::vector<Voxel> voxels(Occupancy value) const;  // sorted; free or occupied
  template <class Visit>
  void for_each_known(Visit visit) const {  // visit(Voxel, Occupancy), in the order in which blocks were made
    for (const ValueBlock& b : values_.blocks()) {
      for_each_bit(b.key, b.known, [&](Voxel v) { visit(v, at(v)); });
    }
  }

  /// Changes: the revision grows with every insert or set that changes a value. A consumer keeps the revision it saw
  /// and asks later which blocks hold voxels whose value changed after it; the cost is one look at each block's number.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] std::vector<BlockKey> blocks_changed_since(std::uint64_t revision) const;

  class Store;  // internal/

 private:
  class Scratch;

  VoxelMapParams params_;
  VoxelBlocks values_;
  std::uint64_t revision_ = 0;
  std::unique_ptr<Store> store_;
  std::unique_ptr<Scratch> scratch_;
};

/// Every occupied voxel grown by `radius` voxels in x and y (4.2.1 and the authors' code); what was free or unknown
/// there becomes occupied.
[[nodiscard]] VoxelMap dilated(const VoxelMap& map, int radius = 1);

/// Speckles: groups of occupied voxels (26 neighbours) of at most `max_voxels` that touch nothing else occupied become
/// free. The floor (z < 0) stays and does not count as touched. The thesis deletes such spurious measurements by hand
/// (4.2.1).
[[nodiscard]] VoxelMap without_speckles(const VoxelMap& map, int max_voxels = 1);

}  // namespace amiss::mapping
