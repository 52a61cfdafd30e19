// Where the alignment of a scan begins: the best poses of a small window round the prior, so that Gauss-Newton does not
// slide into a neighbouring minimum, as the other face of a thin wall is one.
// A distance field, points in the base frame [m], a prior -> the best pose, and a second that lies elsewhere where it
// is nearly as good; the prior itself where no point lies on the map. Exhaustive as real-time correlative scan matching
// (Olson, ICRA 2009): the points are turned once for each yaw and shifted by whole cells of the map.
#pragma once

#include "localize/internal/distance_field.hpp"

namespace amiss::localize::internal {

[[nodiscard]] std::vector<Pose2<Map, Base>> best_in_window(const DistanceField& field,
                                                           const std::vector<Eigen::Vector2d>& points_base,
                                                           const AlignmentPrior& prior);

}  // namespace amiss::localize::internal
