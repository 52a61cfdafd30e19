#include "segment/point_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/random.hpp"

namespace amiss::segment {
namespace {

std::vector<Eigen::Vector3f> some_points(std::size_t n, RandomStream& random) {
  const auto draw = [&] { return static_cast<float>(random.uniform(-0.5, 0.5)); };
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < n; ++i) {
    const float x = draw(), y = draw(), z = draw();
    points.emplace_back(x, y, z);
  }
  return points;
}

TEST(PointGrid, FindsWhatLookingAtEveryPointFinds) {
  RandomStream random(1, "point grid");
  const auto points = some_points(600, random);
  for (const float edge : {0.02F, 0.1F, 0.6F}) {
    const PointGrid grid(points, edge);
    for (const Eigen::Vector3f& place : some_points(60, random)) {
      const auto radius = static_cast<float>(random.uniform(0.01, 0.3));
      std::vector<std::uint32_t> expected, found;
      float least = std::numeric_limits<float>::infinity();
      for (std::uint32_t i = 0; i < points.size(); ++i) {
        const float squared = (points[i] - place).squaredNorm();
        if (squared <= radius * radius) expected.push_back(i);
        least = std::min(least, squared);
      }
      grid.for_each_within(place, radius, [&](std::uint32_t i, float) { found.push_back(i); });
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
      const auto nearest = grid.nearest(place, radius);
      ASSERT_EQ(nearest.has_value(), !expected.empty());
      if (nearest) {
        EXPECT_EQ(nearest->squared_m2, least);
      }
    }
  }
}

TEST(PointGrid, TakesTheNearestOfThoseThatCount) {
  const PointGrid grid({{0.01F, 0, 0}, {0.05F, 0, 0}, {0.3F, 0, 0}}, 0.02F);
  const auto nearest = grid.nearest_of({0, 0, 0}, 0.2F, [](std::uint32_t i) { return i != 0; });
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->index, 1U);
  EXPECT_FALSE(grid.nearest_of({0, 0, 0}, 0.2F, [](std::uint32_t i) { return i == 2; }));
}

TEST(PointGrid, IsEmptyWithoutPoints) {
  const PointGrid grid({}, 0.1F);
  EXPECT_EQ(grid.size(), 0U);
  EXPECT_FALSE(grid.any_within({0, 0, 0}, 1.0F));
}

}  // namespace
}  // namespace amiss::segment
