// Whether triangles bound solids, so that their back faces can never be seen.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>

namespace amiss::sim::internal {

/// True when every edge is shared by triangles of opposite direction and every connected part turns its front
/// outwards. Corners with equal coordinates count as one.
[[nodiscard]] bool is_closed(std::span<const Eigen::Vector3f> vertices, std::span<const std::uint32_t> indices);

}  // namespace amiss::sim::internal
