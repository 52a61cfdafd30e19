#include "mapping/internal/marching_cubes.hpp"

namespace amiss::mapping {
namespace {

using Triangles = std::vector<std::array<std::uint8_t, 3>>;

int edge_between(int a, int b) {
  const int low = a < b ? a : b, bit = a ^ b;
  const int axis = bit == 1 ? 0 : (bit == 2 ? 1 : 2);
  // The corner's other two bits, the lower one first.
  const int k = axis == 0 ? low >> 1 : (axis == 1 ? (low & 1) | ((low >> 1) & 2) : low & 3);
  return 4 * axis + k;
}

/// The four corners of a face, counter-clockwise seen from outside the cube.
std::array<int, 4> face_corners(int axis, int side) {
  const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3), base = side << axis;
  if (side == 1) return {base, base | u, base | u | v, base | v};
  return {base, base | v, base | u | v, base | u};
}

/// Walking around each face, a run of inside corners is entered over one cut edge and left over another: these two are
/// joined. Every cut edge is entered on one of its faces and left on the other, so the joints close to loops.
std::array<int, kCubeEdges> joints(unsigned pattern) {
  std::array<int, kCubeEdges> next;
  next.fill(-1);
  for (int face = 0; face < 6; ++face) {
    const auto corners = face_corners(face / 2, face % 2);
    const auto inside = [&](int i) { return ((pattern >> corners[static_cast<std::size_t>(i & 3)]) & 1U) != 0; };
    const auto edge = [&](int i) {
      return edge_between(corners[static_cast<std::size_t>(i & 3)], corners[static_cast<std::size_t>((i + 1) & 3)]);
    };
    for (int i = 0; i < 4; ++i) {
      if (inside(i) || !inside(i + 1)) continue;
      int last = i + 1;
      while (inside(last + 1)) ++last;
      next[static_cast<std::size_t>(edge(i))] = edge(last);
    }
  }
  return next;
}

Triangles triangles_of(unsigned pattern) {
  Triangles triangles;
  std::array<int, kCubeEdges> next = joints(pattern);
  for (int begin = 0; begin < kCubeEdges; ++begin) {
    std::vector<std::uint8_t> loop;
    for (int e = begin; next[static_cast<std::size_t>(e)] >= 0;) {
      loop.push_back(static_cast<std::uint8_t>(e));
      const int following = next[static_cast<std::size_t>(e)];
      next[static_cast<std::size_t>(e)] = -1;
      e = following;
    }
    for (std::size_t i = 2; i < loop.size(); ++i) triangles.push_back({loop[0], loop[i - 1], loop[i]});
  }
  return triangles;
}

}  // namespace

CubeEdge cube_edge(int edge) {
  const int axis = edge / 4, k = edge % 4;
  const int corner = axis == 0 ? k << 1 : (axis == 1 ? (k & 1) | ((k & 2) << 1) : k);
  return {corner, axis};
}

const Triangles& cube_triangles(unsigned pattern) {
  static const std::array<Triangles, 256> table = [] {
    std::array<Triangles, 256> all;
    for (unsigned p = 0; p < 256; ++p) all[p] = triangles_of(p);
    return all;
  }();
  return table[pattern & 255U];
}

}  // namespace amiss::mapping
