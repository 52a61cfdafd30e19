// What single rays say: end points hit, every other voxel on the way is missed.
#pragma once

#include <vector>

#include "core/frames.hpp"
#include "mapping/internal/evidence.hpp"

namespace amiss::mapping {

/// Sorted by block. Points that are not finite are skipped.
[[nodiscard]] std::vector<BlockEvidence> ray_evidence(const Cloud<Map>& points, const Point<Map>& origin,
                                                      double resolution_m);

}  // namespace amiss::mapping
