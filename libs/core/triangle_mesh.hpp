// A surface of triangles with the vertices' colours and normals.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/frames.hpp"

namespace amiss {

/// Vertices in frame In [m]; three indices of vertices for a triangle, counter-clockwise seen from outside.
template <class In>
struct TriangleMesh {
  Cloud<In> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace amiss
