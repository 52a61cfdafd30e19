// Voxels that appeared, merged into regions of interest (thesis 4.2.4, 4.2.5, Table 4.1).
//
// in: Difference.appeared + the current VoxelMap (resolution and evidence)     out: Regions in the map frame [m],
// sorted by position. Voxels are merged when their centres are at most sqrt(2) voxels apart; groups that are too small,
// too large, too tall, too wide or hover above the floor are left out. Small things cover one to three voxels of 5 cm,
// where Table 4.1 asks for four; they count when enough frames hit them.
#pragma once

#include <vector>

#include "core/params.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::change {

struct RegionParams {
  int min_voxels = 2;         // c_min; 4 in Table 4.1, see README
  int max_voxels = 1000;      // c_max
  double max_height_m = 0.5;  // c_height
  double max_across_m = 0.6;
  double max_floor_gap_m = 0.075;  // 1.5 voxels
  int min_hit_frames = 3;          // of a voxel that counts as evidence
  int lone_hit_frames = 10;        // of a voxel that is believed even where a region has fewer than c_min
};
void describe(ParamTable& table, RegionParams& params);

/// A bounding cylinder that stands upright: centre of the largest extent in x and y, radius to the farthest corner.
struct Region {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  double z_low_m = 0.0, z_high_m = 0.0;
  std::vector<mapping::Voxel> voxels;            // sorted
  std::vector<Eigen::Vector3f> voxel_centres_m;  // in the map frame, as voxels
  int evident_voxels = 0;                        // hit in at least min_hit_frames frames
  int hit_frames = 0;                            // of the voxel that was hit most often
};

[[nodiscard]] std::vector<Region> regions(const std::vector<mapping::Voxel>& appeared, const mapping::VoxelMap& current,
                                          const RegionParams& params = {});

/// The groups alone: voxels (in any order) merged by distance, each group sorted, groups sorted by their first voxel.
[[nodiscard]] std::vector<std::vector<mapping::Voxel>> clusters(const std::vector<mapping::Voxel>& voxels);

}  // namespace amiss::change
