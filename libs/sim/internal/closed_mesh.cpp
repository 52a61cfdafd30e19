#include "sim/internal/closed_mesh.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace amiss::sim::internal {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// For each vertex the first one (of a sorted order) at the same place.
std::vector<std::uint32_t> weld(std::span<const Eigen::Vector3f> vertices) {
  const auto key = [&](std::uint32_t i) { return std::array{vertices[i].x(), vertices[i].y(), vertices[i].z()}; };
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<std::uint32_t> welded(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    welded[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? welded[order[i - 1]] : order[i];
  return welded;
}

bool edges_match(const std::vector<std::uint32_t>& corners) {
  std::vector<Edge> there, back;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = corners[t + k], to = corners[t + (k + 1) % 3];
      there.emplace_back(from, to);
      back.emplace_back(to, from);
    }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  return there == back;
}

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

bool parts_face_outwards(std::span<const Eigen::Vector3f> vertices, const std::vector<std::uint32_t>& corners) {
  std::vector<std::uint32_t> parent(vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
    for (std::size_t k = 1; k < 3; ++k) parent[root(parent, corners[t + k])] = root(parent, corners[t]);
  std::vector<double> volume(vertices.size(), 0.0);
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    const Eigen::Vector3d a = vertices[corners[t]].cast<double>(), b = vertices[corners[t + 1]].cast<double>(),
                          c = vertices[corners[t + 2]].cast<double>();
    volume[root(parent, corners[t])] += a.dot(b.cross(c)) / 6.0;
  }
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
    if (volume[root(parent, corners[t])] <= 0.0) return false;
  return true;
}

}  // namespace

bool is_closed(std::span<const Eigen::Vector3f> vertices, std::span<const std::uint32_t> indices) {
  const std::vector<std::uint32_t> welded = weld(vertices);
  std::vector<std::uint32_t> corners;
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    const auto a = welded[indices[t]], b = welded[indices[t + 1]], c = welded[indices[t + 2]];
    if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
  }
  return !corners.empty() && edges_match(corners) && parts_face_outwards(vertices, corners);
}

}  // namespace amiss::sim::internal
