// What a voxel of a reconstruction looks like, in numbers that a forest can decide on.
// in: cloud in the map frame, z up, floor at z = 0     out: for each voxel kFeatureCount numbers:
//   height, normal, colour;
//   shape and colour of what lies around it, at four scales (windows of 6 to 48 cm);
//   how much surface, and how much level surface, is in boxes around, above and below it (windows of 12 to 68 cm), and
//   in boxes that stand on the floor there (28 to 132 cm);
//   how high it is above the level surface below it.
// Nothing of it depends on where in the room the voxel is, nor on which way the room is turned by a right angle.
#pragma once

#include <span>

#include "semantics/voxels.hpp"

namespace amiss::semantics {

inline constexpr std::size_t kFeatureCount = 178;

struct VoxelFeatures {
  Voxels voxels;
  std::vector<float> values;  // kFeatureCount for each voxel

  [[nodiscard]] std::span<const float> of(std::size_t voxel) const {
    return std::span(values).subspan(voxel * kFeatureCount, kFeatureCount);
  }
};

/// The same for any number of threads.
[[nodiscard]] VoxelFeatures voxel_features(const Cloud<Map>& cloud, double voxel_m, int threads);

}  // namespace amiss::semantics
