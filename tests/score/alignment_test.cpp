#include "score/alignment.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"

namespace amiss::score {
namespace {

double between(double low, double high) { return *rc::gen::inRange(0, 1000001) * 1e-6 * (high - low) + low; }

/// Poses of a drive, true ones from estimates under a known alignment, with noise on the estimates.
std::vector<PosePair> drive(const Pose2<World, Map>& T_world_map, double noise_m, int poses) {
  RandomStream random(4, "drive");
  std::vector<PosePair> pairs;
  for (int i = 0; i < poses; ++i) {
    const Pose2<Map, Base> T_map_base{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)};
    PosePair pair;
    pair.T_world_base = T_world_map * T_map_base;
    pair.T_map_base = T_map_base;
    pair.T_map_base.x_m += noise_m * random.normal();
    pair.T_map_base.y_m += noise_m * random.normal();
    pairs.push_back(pair);
  }
  return pairs;
}

RC_GTEST_PROP(Alignment, FindsAnExactOneAgain, ()) {
  const Pose2<World, Map> wanted{between(-9, 9), between(-9, 9), between(-3.1, 3.1)};
  const auto pairs = drive(wanted, 0.0, 30);
  const Pose2<World, Map> found = align(pairs);
  RC_ASSERT((found.position() - wanted.position()).norm() < 1e-9);
  RC_ASSERT(std::abs(wrap_angle(found.yaw_rad - wanted.yaw_rad)) < 1e-9);
  const LocalizationError error = localization_error(pairs, found);
  RC_ASSERT(error.max_m < 1e-9 && error.rmse_rad < 1e-9);
}

/// Least squares: no small step away from it is better.
TEST(Alignment, NoNeighbourIsBetter) {
  const auto pairs = drive({1.0, -2.0, 0.7}, 0.2, 200);
  const Pose2<World, Map> best = align(pairs);
  const double error = localization_error(pairs, best).rmse_m;
  for (const double step : {-1e-3, 1e-3}) {
    EXPECT_GT(localization_error(pairs, {best.x_m + step, best.y_m, best.yaw_rad}).rmse_m, error);
    EXPECT_GT(localization_error(pairs, {best.x_m, best.y_m + step, best.yaw_rad}).rmse_m, error);
    EXPECT_GT(localization_error(pairs, {best.x_m, best.y_m, best.yaw_rad + step}).rmse_m, error);
  }
}

TEST(Alignment, OnOnePlaceTheFirstPairDecides) {
  PosePair pair;
  pair.T_world_base = {3.0, 4.0, 1.0};
  pair.T_map_base = {0.0, 0.0, 0.0};
  const Pose2<World, Map> T_world_map = align({pair, pair, pair});
  EXPECT_NEAR(T_world_map.x_m, 3.0, 1e-12);
  EXPECT_NEAR(T_world_map.y_m, 4.0, 1e-12);
  EXPECT_NEAR(T_world_map.yaw_rad, 1.0, 1e-12);
}

TEST(Alignment, NoPairs) {
  EXPECT_EQ(align({}).position(), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(localization_error({}, {}).poses, 0U);
}

TEST(LocalizationError, IsTheRootOfTheMeanSquare) {
  std::vector<PosePair> pairs(2);
  pairs[0].T_map_base = {0.3, 0.0, 0.1};  // truth is at the origin
  pairs[1].T_map_base = {0.0, -0.4, -0.3};
  const LocalizationError error = localization_error(pairs, {});
  EXPECT_NEAR(error.rmse_m, std::sqrt((0.09 + 0.16) / 2.0), 1e-12);
  EXPECT_NEAR(error.rmse_rad, std::sqrt((0.01 + 0.09) / 2.0), 1e-12);
  EXPECT_NEAR(error.max_m, 0.4, 1e-12);
  EXPECT_EQ(error.poses, 2U);
}

TEST(LocalizationError, TurnsTheShortWay) {
  std::vector<PosePair> pairs(1);
  pairs[0].T_world_base.yaw_rad = 3.1;
  pairs[0].T_map_base.yaw_rad = -3.1;
  EXPECT_NEAR(localization_error(pairs, {}).rmse_rad, 2.0 * std::numbers::pi - 6.2, 1e-12);
}

}  // namespace
}  // namespace amiss::score
