// Meshes made from numbers, for the shapes that world::Geometry has no kind of its own for.
#pragma once

#include <memory>

#include "world/world.hpp"

namespace amiss::world {

/// Along z, `length` without the two half spheres, origin in the middle.
[[nodiscard]] std::shared_ptr<const Mesh> capsule_mesh(double radius_m, double length_m);
[[nodiscard]] std::shared_ptr<const Mesh> ellipsoid_mesh(const Eigen::Vector3d& radii_m);
/// The same triangles wound the other way, for scales that mirror.
[[nodiscard]] std::shared_ptr<const Mesh> inside_out(const Mesh& mesh);
[[nodiscard]] Eigen::Vector3d centre_of_bounds(const Mesh& mesh);

}  // namespace amiss::world
