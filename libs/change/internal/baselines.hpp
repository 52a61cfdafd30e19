// The two baselines of Section 5.3.3, which compare whole rooms. out: novel points of the thinned current scene,
// ascending.
#pragma once

#include "change/internal/room_pair.hpp"

namespace amiss::change::internal {

/// Chapter 4 for all heights: occupied voxels of 5 cm that the reference, dilated, does not have, merged and filtered
/// by Table 4.1. Where the reference did not look nothing is said.
[[nodiscard]] segment::Indices octomap_difference(const Scene& reference, const ThinnedScene& current);

/// Ambrus et al.: align the whole, subtract (Equation 5.1), cluster, drop what is planar or small.
[[nodiscard]] segment::Indices metaroom_difference(const RoomPair& pair, const NovelParams& params);

}  // namespace amiss::change::internal
