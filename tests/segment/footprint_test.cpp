#include "segment/footprint.hpp"

#include <gtest/gtest.h>

namespace amiss::segment {
namespace {

/// A square ring of cells of 10 cm, 5 x 5 with a hole of 3 x 3.
Footprint ring(float x0) {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> all;
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      if (x > 0 && x < 4 && y > 0 && y < 4) continue;
      all.push_back(static_cast<std::uint32_t>(points.size()));
      points.emplace_back(x0 + 0.1F * static_cast<float>(x) + 0.05F, 0.1F * static_cast<float>(y) + 0.05F, 0.0F);
    }
  }
  return {points, all, 0.1F};
}

TEST(Footprint, CoversItsPointsAndNoHoleUntilFilled) {
  const Footprint f = ring(0.0F);
  EXPECT_NEAR(f.area_m2(), 0.16, 1e-6);
  EXPECT_TRUE(f.contains(0.02F, 0.02F));
  EXPECT_FALSE(f.contains(0.25F, 0.25F));
  EXPECT_FALSE(f.contains(-0.01F, 0.25F));
  EXPECT_TRUE(f.filled().contains(0.25F, 0.25F));
  EXPECT_FALSE(f.filled().contains(-0.01F, 0.25F));
  EXPECT_NEAR(f.filled().area_m2(), 0.25, 1e-6);
}

TEST(Footprint, GrowsToAllSides) {
  const Footprint wide = ring(0.0F).dilated(1);
  EXPECT_TRUE(wide.contains(-0.05F, 0.55F));
  EXPECT_FALSE(wide.contains(-0.15F, 0.25F));
  EXPECT_NEAR(wide.area_m2(), 0.48, 1e-6);  // 7 x 7 but the middle
}

TEST(Footprint, UnitesAndShares) {
  const Footprint a = ring(0.0F), b = ring(1.0F), c = ring(0.4F);
  EXPECT_NEAR(a.united(b).area_m2(), 0.32, 1e-6);
  EXPECT_EQ(a.shared_area_m2(b), 0.0);
  EXPECT_NEAR(a.shared_area_m2(c), 0.05, 1e-6);  // one column
  EXPECT_NEAR(Footprint(0.1F).united(a).area_m2(), a.area_m2(), 1e-9);
  EXPECT_EQ(Footprint(0.1F).filled().dilated(2).area_m2(), 0.0);
}

}  // namespace
}  // namespace amiss::segment
