// Geometry of a body -> triangles of its frame, ready to be drawn.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "world/world.hpp"

namespace amiss::sim::internal {

struct Triangles {
  std::vector<Eigen::Vector3f> positions;  // of the shape's frame [m]
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;    // (0, 0) is the lower left corner of the picture
  std::vector<Rgb> colours;            // empty, or of each vertex
  std::vector<std::uint32_t> indices;  // three a triangle, counter-clockwise from outside
  bool closed = true;                  // false: both sides may be seen
};

/// Boxes show the whole texture on each side, cylinders wind it round once, planes are finite.
[[nodiscard]] Triangles triangulate(const world::Geometry& geometry);

}  // namespace amiss::sim::internal
