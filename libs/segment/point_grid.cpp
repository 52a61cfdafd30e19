#include "segment/point_grid.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

namespace amiss::segment {

PointGrid::PointGrid(std::vector<Eigen::Vector3f> points, float edge_m)
    : edge_m_(edge_m), inverse_edge_(1.0F / edge_m) {
  assert(edge_m > 0.0F);
  std::vector<Cube> cubes(points.size());
  std::transform(points.begin(), points.end(), cubes.begin(), [&](const auto& p) { return cube_of(p); });
  order_.resize(points.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Cube &p = cubes[a], &q = cubes[b];
    return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
  });
  sorted_.reserve(points.size());
  for (const std::uint32_t i : order_) sorted_.push_back(points[i]);

  std::size_t used = 0;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    if (k == 0 || !(cubes[order_[k]] == cubes[order_[k - 1]])) ++used;
  }
  slots_.resize(std::bit_ceil(2 * used + 2));
  mask_ = slots_.size() - 1;
  for (std::uint32_t begin = 0; begin < order_.size();) {
    std::uint32_t end = begin + 1;
    const Cube cube = cubes[order_[begin]];
    while (end < order_.size() && cubes[order_[end]] == cube) ++end;
    slots_[slot_of(cube)] = {cube, {begin, end}};
    begin = end;
  }
}

PointGrid::Cube PointGrid::cube_of(const Eigen::Vector3f& p) const {
  const auto index = [&](float v) { return static_cast<int>(std::floor(v * inverse_edge_)); };
  return {index(p.x()), index(p.y()), index(p.z())};
}

std::size_t PointGrid::slot_of(Cube cube) const {
  std::uint64_t h = static_cast<std::uint32_t>(cube.x) * 0x9E3779B97F4A7C15ULL;
  h ^= (static_cast<std::uint32_t>(cube.y) * 0xC2B2AE3D27D4EB4FULL) >> 7U;
  h ^= (static_cast<std::uint32_t>(cube.z) * 0x165667B19E3779F9ULL) >> 13U;
  h ^= h >> 32U;
  std::size_t slot = static_cast<std::size_t>(h) & mask_;
  while (slots_[slot].range.begin != slots_[slot].range.end && !(slots_[slot].cube == cube)) slot = (slot + 1) & mask_;
  return slot;
}

float PointGrid::least_distance(const Eigen::Vector3f& place, Cube home, int ring) const {
  if (ring == 0) return 0.0F;
  float border = edge_m_;
  for (int k = 0; k < 3; ++k) {
    const auto low = edge_m_ * static_cast<float>(k == 0 ? home.x : k == 1 ? home.y : home.z);
    border = std::min({border, place[k] - low, low + edge_m_ - place[k]});
  }
  return edge_m_ * static_cast<float>(ring - 1) + std::max(0.0F, border);
}

std::optional<PointGrid::Neighbour> PointGrid::nearest(const Eigen::Vector3f& place, float radius_m) const {
  return nearest_of(place, radius_m, [](std::uint32_t) { return true; });
}

}  // namespace amiss::segment
