#include "sim/internal/noise_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace amiss::sim::internal {
namespace {

constexpr int kWidth = 83, kHeight = 9;

/// Walls and posts at random distances; nothing at all in some columns.
std::vector<float> random_depth(std::uint64_t seed) {
  RandomStream random(seed, "noise rows");
  std::vector<float> depth;
  float z = 2.0F;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    if (random.below(6) == 0) z = random.below(8) == 0 ? 0.0F : static_cast<float>(random.uniform(0.5, 6.0));
    depth.push_back(z);
  }
  return depth;
}

float at(const std::vector<float>& depth, int row, int u) { return depth[static_cast<std::size_t>(row * kWidth + u)]; }

bool inside(int row, int u) { return row >= 0 && row < kHeight && u >= 0 && u < kWidth; }

bool is_edge(const std::vector<float>& depth, int row, int u, float jump) {
  const float z = at(depth, row, u);
  for (const auto& [dr, du] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    if (!inside(row + dr, u + du)) continue;
    const float other = at(depth, row + dr, u + du);
    if (std::abs(other - z) > jump * std::min(other, z)) return true;
  }
  return false;
}

TEST(NoiseRows, EdgesAreWhereANeighbourLiesElsewhere) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<float> depth = random_depth(seed);
    const std::vector<std::uint8_t> mask = depth_edges(depth, kWidth, 0.03F);
    for (int row = 0; row < kHeight; ++row)
      for (int u = 0; u < kWidth; ++u) {
        bool near = false;
        for (int k = -kLateralReach; k <= kLateralReach; ++k)
          near = near || (inside(row, u + k) && is_edge(depth, row, u + k, 0.03F));
        const int expected = (is_edge(depth, row, u, 0.03F) ? kEdge : 0) | (near ? kEdgeNear : 0);
        ASSERT_EQ(mask[static_cast<std::size_t>(row * kWidth + u)], expected) << seed << " " << row << " " << u;
      }
  }
}

/// By definition: does a pixel further right, three or more away, cover the projector's column that lights this one?
bool is_dark(const std::vector<float>& depth, int row, int u, float fx_times_baseline, float most) {
  const auto column = [&](int v) {
    const float z = at(depth, row, v);
    return static_cast<int>(static_cast<float>(v) - (z > 0.0F ? std::min(fx_times_baseline / z, most) : 0.0F) + most);
  };
  for (int v = u + 3; v < kWidth; ++v)
    if (column(v) == column(u) || column(v) + 1 == column(u)) return true;
  return false;
}

TEST(NoiseRows, ShadowsLieWhereSomethingNearerTakesTheProjectorsColumn) {
  int dark = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<float> depth = random_depth(seed);
    std::vector<std::uint8_t> reflectance(depth.size(), 200);
    darken_shadows(depth, reflectance, kWidth, 40.0F, 0.4F);
    for (int row = 0; row < kHeight; ++row)
      for (int u = 0; u < kWidth; ++u) {
        const bool expected = is_dark(depth, row, u, 40.0F, 40.0F / 0.4F);
        ASSERT_EQ(reflectance[static_cast<std::size_t>(row * kWidth + u)] == 0, expected) << seed << " " << u;
        dark += expected ? 1 : 0;
      }
  }
  EXPECT_GT(dark, 500);
}

}  // namespace
}  // namespace amiss::sim::internal
