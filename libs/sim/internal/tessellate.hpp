// Geometry -> triangles in the shape's own frame, for cutting and rasterising. Round things become prisms of kFacets
// sides whose corners lie on the true surface.
#pragma once

#include <array>
#include <vector>

#include "world/world.hpp"

namespace amiss::sim::internal {

inline constexpr int kFacets = 48;
using Triangle = std::array<Eigen::Vector3d, 3>;

[[nodiscard]] std::vector<Triangle> tessellate(const world::Geometry& geometry);

/// Everything but meshes and planes is convex and filled.
[[nodiscard]] bool is_solid(const world::Geometry& geometry);

}  // namespace amiss::sim::internal
