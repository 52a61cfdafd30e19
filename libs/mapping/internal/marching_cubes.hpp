// Which triangles a cube gets for each pattern of corners inside and outside (Lorensen and Cline 1987).
//
// Corner c of a cube lies at (c & 1, c >> 1 & 1, c >> 2). Edge e = 4 axis + k joins the k-th corner whose bit `axis` is
// 0 with its neighbour along the axis. The triangles of pattern p (bit c: corner c is inside) are worked out, not
// listed: on each face the cut edges are joined so that inside corners that only share a diagonal stay apart, which
// two cubes decide alike for the face between them, so that meshes have no cracks.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace amiss::mapping {

struct CubeEdge {
  int corner = 0, axis = 0;  // from `corner` to `corner | 1 << axis`
};
inline constexpr int kCubeEdges = 12;
[[nodiscard]] CubeEdge cube_edge(int edge);

/// Three edges for a triangle, counter-clockwise seen from outside.
[[nodiscard]] const std::vector<std::array<std::uint8_t, 3>>& cube_triangles(unsigned pattern);

}  // namespace amiss::mapping
