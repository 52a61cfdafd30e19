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
    const Cube p = brick_of(cubes[a]), q = brick_of(cubes[b]);
    const unsigned m = number_in_brick(cubes[a]), n = number_in_brick(cubes[b]);
    return std::tie(p.x, p.y, p.z, m, a) < std::tie(q.x, q.y, q.z, n, b);
  });
  sorted_.reserve(points.size());
  for (const std::uint32_t i : order_) sorted_.push_back(points[i]);
  put_bricks(cubes);
}

void PointGrid::put_bricks(const std::vector<Cube>& cubes) {
  const auto starts = [&](std::size_t k, const auto& of) {
    return k == 0 || !(of(cubes[order_[k]]) == of(cubes[order_[k - 1]]));
  };
  std::size_t used = 0;
  for (std::size_t k = 0; k < order_.size(); ++k) used += starts(k, brick_of) ? 1U : 0U;
  bricks_.resize(std::bit_ceil(2 * used + 2));
  mask_ = bricks_.size() - 1;
  Brick* brick = nullptr;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const Cube& cube = cubes[order_[k]];
    if (starts(k, brick_of)) {
      brick = &bricks_[slot_of(brick_of(cube))];
      *brick = {brick_of(cube), 0, static_cast<std::uint32_t>(begins_.size())};
    }
    if (!starts(k, [](const Cube& c) { return c; })) continue;
    brick->cubes |= std::uint64_t{1} << number_in_brick(cube);
    begins_.push_back(static_cast<std::uint32_t>(k));
  }
  begins_.push_back(static_cast<std::uint32_t>(order_.size()));
}

PointGrid::Cube PointGrid::cube_of(const Eigen::Vector3f& p) const {
  const auto index = [&](float v) { return static_cast<int>(std::floor(v * inverse_edge_)); };
  return {index(p.x()), index(p.y()), index(p.z())};
}

std::size_t PointGrid::slot_of(const Cube& brick) const {
  // Bricks beside one another differ in few bits of each index: all have to reach the bits that the mask keeps.
  std::uint64_t h = static_cast<std::uint32_t>(brick.x) * 0x9E3779B97F4A7C15ULL;
  h = (h ^ (h >> 29U) ^ static_cast<std::uint32_t>(brick.y)) * 0xC2B2AE3D27D4EB4FULL;
  h = (h ^ (h >> 29U) ^ static_cast<std::uint32_t>(brick.z)) * 0x165667B19E3779F9ULL;
  h ^= h >> 32U;
  std::size_t slot = static_cast<std::size_t>(h) & mask_;
  while (bricks_[slot].cubes != 0 && !(bricks_[slot].place == brick)) slot = (slot + 1) & mask_;
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
