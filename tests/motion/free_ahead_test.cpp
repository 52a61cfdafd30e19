#include "motion/internal/free_ahead.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"
#include "motion/test_flat.hpp"

namespace amiss::motion::internal {
namespace {

constexpr double kStop_m = 0.26;

/// Goes on in steps until a hit comes nearer than the radius.
double slow_free_m(const std::vector<Eigen::Vector2d>& hits, const Eigen::Vector2d& direction, double look_m) {
  for (double s = 0.0; s < look_m; s += 0.001) {
    for (const auto& hit : hits) {
      if ((hit - s * direction).norm() < kStop_m) return s;
    }
  }
  return look_m;
}

RC_GTEST_PROP(FreeByHits, IsTheWayUntilAHitComesTooNear, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "hits");
  std::vector<Eigen::Vector2d> hits(random.below(6));
  for (auto& hit : hits) {
    const double angle = random.uniform(-3.2, 3.2);
    hit = random.uniform(kStop_m + 0.002, 2.0) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  const double angle = random.uniform(-3.2, 3.2);
  const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  RC_ASSERT(std::abs(free_by_hits_m(hits, direction, kStop_m, 1.0) - slow_free_m(hits, direction, 1.0)) < 0.002);
}

TEST(FreeByHits, WhatIsTooNearStopsOnlyMotionTowardsIt) {
  const std::vector<Eigen::Vector2d> hits{{0.25, 0.0}};
  EXPECT_EQ(free_by_hits_m(hits, {1.0, 0.0}, kStop_m, 1.0), 0.0);
  EXPECT_EQ(free_by_hits_m(hits, {-1.0, 0.0}, kStop_m, 1.0), 1.0);
  EXPECT_EQ(free_by_hits_m(hits, {0.0, 1.0}, kStop_m, 1.0), 1.0);
}

TEST(FreeByMap, EndsWhereTheClearanceDoes) {
  const DriveMap map(empty_room(4.0, 4.0), {});
  EXPECT_NEAR(free_by_map_m(map, {2.0, 2.0}, {4.5, 2.0}, kStop_m), 1.74, 0.06);
  EXPECT_NEAR(free_by_map_m(map, {2.0, 2.0}, {3.0, 2.0}, kStop_m), 1.0, 1e-9);
  EXPECT_NEAR(free_by_map_m(map, {0.1, 2.0}, {1.5, 2.0}, kStop_m), 1.4, 1e-9);  // out of a narrow place
  EXPECT_LT(free_by_map_m(map, {0.2, 2.0}, {-1.5, 2.0}, kStop_m), 0.1);         // further into it
}

TEST(AwayFromSides, PushesFromTheNearerSide) {
  const Eigen::Vector2d ahead(1.0, 0.0);
  EXPECT_EQ(away_from_sides({}, ahead, kStop_m, 0.32), Eigen::Vector2d::Zero());
  EXPECT_LT(away_from_sides(std::vector<Eigen::Vector2d>{{0.0, 0.28}}, ahead, kStop_m, 0.32).y(), -0.1);
  EXPECT_GT(away_from_sides(std::vector<Eigen::Vector2d>{{0.0, -0.28}}, ahead, kStop_m, 0.32).y(), 0.1);
  EXPECT_NEAR(away_from_sides(std::vector<Eigen::Vector2d>{{0.0, -0.3}, {0.0, 0.3}}, ahead, kStop_m, 0.32).norm(), 0.0,
              1e-12);
}

}  // namespace
}  // namespace amiss::motion::internal
