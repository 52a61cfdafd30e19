// Two thinned scenes laid on one another: which planes are surfaces of the room, what is stuff, and what of it stays
// where it was (Equation 5.1 under the local drift).
#pragma once

#include "change/internal/drift.hpp"
#include "change/internal/thinned_scene.hpp"

namespace amiss::change::internal {

/// A surface that both scenes have, as it lies in the current one.
struct Support {
  segment::SupportPlane plane;
  segment::Footprint ground;  // where both scenes show it, holes filled, a little wider
};

struct RoomPair {
  ThinnedScene reference, current;  // on_plane: of surfaces only
  std::vector<Support> supports;
  Drift drift;
  segment::Indices stuff;               // of the reference: not on a surface
  segment::PointGrid stuff_grid;        // of `stuff`, by its position in that list
  std::vector<Eigen::Vector3f> placed;  // the current points, laid onto the reference
  std::vector<bool> explained;          // for each current point: the reference has it at that place
  const mapping::VoxelMap* reference_space = nullptr;
  const mapping::VoxelMap* current_space = nullptr;
};

/// Does the reference have something at p (Equation 5.1)? A surface explains what is no higher above it than its own
/// points are.
[[nodiscard]] bool explains(const ThinnedScene& reference, const Eigen::Vector3f& p, const NovelParams& params);

[[nodiscard]] RoomPair room_pair(const Scene& reference, const Scene& current, const NovelParams& params);

}  // namespace amiss::change::internal
