// The ground plane by RANSAC, near the horizontal and near z = 0 of the map.
#pragma once

#include <optional>

#include "segment/internal/window.hpp"

namespace amiss::segment::internal {

/// None where too few points lie on such a plane.
[[nodiscard]] std::optional<Plane> ground_of(const Window& window, const Params& params);

[[nodiscard]] inline float height_above(const Plane& plane, const Eigen::Vector3f& p_map) {
  return plane.normal_map.cast<float>().dot(p_map) + static_cast<float>(plane.d_m);
}

}  // namespace amiss::segment::internal
