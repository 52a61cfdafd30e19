// Object-map alignment (Section 5.2.2): ICP in x, y and yaw of an object onto the reference's stuff, from several
// starts, and the share of its points that then lie within d of the reference.
// in: points of the object, already laid onto the reference by the drift; stuff of the reference near them [m].
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "change/novel.hpp"

namespace amiss::change::internal {

struct Fit {
  Eigen::Isometry3f T = Eigen::Isometry3f::Identity();  // T_reference_rest: moves the object as it rests
  double overlap = 0.0;
  double moved_m = 0.0, turned_rad = 0.0;
};

/// The best of the fits that move the object no farther than c_ref.
[[nodiscard]] Fit best_fit(const std::vector<Eigen::Vector3f>& object, const std::vector<Eigen::Vector3f>& reference,
                           const NovelParams& params);

}  // namespace amiss::change::internal
