// Axis-aligned bounds of geometry, shapes and bodies [m]; planes count with their finite size, and no thickness.
#pragma once

#include <Eigen/Geometry>

#include "world/world.hpp"

namespace amiss::world {

/// Of a geometry moved by T (to any frame).
[[nodiscard]] Eigen::AlignedBox3d bounds(const Geometry& geometry, const Eigen::Isometry3d& T);
/// Of all shapes in the body's frame; empty where there are none.
[[nodiscard]] Eigen::AlignedBox3d bounds(const std::vector<Shape>& shapes);
/// Of a body's collision shapes (its visuals where it has none) in the world frame.
[[nodiscard]] Eigen::AlignedBox3d bounds_in_world(const Body& body);

}  // namespace amiss::world
