#include "sim/odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace amiss::sim {
namespace {

/// The last odometry after straight steps of 6 mm.
Odometry after_driving(const OdometryParams& params, std::uint64_t seed, double distance_m) {
  OdometryModel model(params, RandomStream(seed, "odometry"), {1, 2, 0.5});
  Odometry last;
  const int steps = static_cast<int>(std::lround(distance_m / 0.006));
  for (int i = 1; i <= steps; ++i) {
    const double s = 0.006 * i;
    last = model.update({}, {1 + s * std::cos(0.5), 2 + s * std::sin(0.5), 0.5});
  }
  return last;
}

TEST(Odometry, WithoutNoiseIsTheMotionItself) {
  const Odometry last = after_driving({0, 0, 0, 0, 0}, 1, 3.0);
  EXPECT_NEAR(last.T_odom_base.x_m, 3.0, 1e-9);
  EXPECT_NEAR(last.T_odom_base.y_m, 0.0, 1e-9);
  EXPECT_NEAR(last.T_odom_base.yaw_rad, 0.0, 1e-9);
}

TEST(Odometry, StandingStillDoesNotDrift) {
  OdometryModel model({}, RandomStream(3, "odometry"), {1, 2, 0.5});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(model.update({}, {1, 2, 0.5}).T_odom_base.position().norm(), 0.0);
}

TEST(Odometry, ErrorsGrowWithTheDistanceAsStated) {
  const OdometryParams params;
  const int runs = 400;
  const double distance_m = 4.0;
  double length_squares = 0.0, yaw_squares = 0.0, length_sum = 0.0;
  for (std::uint64_t seed = 0; seed < runs; ++seed) {
    const Odometry last = after_driving(params, seed, distance_m);
    const double error = last.T_odom_base.x_m - distance_m;
    length_sum += error;
    length_squares += error * error;
    yaw_squares += last.T_odom_base.yaw_rad * last.T_odom_base.yaw_rad;
  }
  const double expected_m = std::hypot(params.scale_sigma * distance_m, params.drift_m * std::sqrt(distance_m));
  EXPECT_NEAR(length_sum / runs, 0.0, 3.0 * expected_m / std::sqrt(runs));
  EXPECT_NEAR(std::sqrt(length_squares / runs), expected_m, 0.15 * expected_m);
  const double expected_rad = params.yaw_drift_rad * std::sqrt(distance_m);
  EXPECT_NEAR(std::sqrt(yaw_squares / runs), expected_rad, 0.15 * expected_rad);
}

TEST(Odometry, AFullTurnCostsAboutADegreeAndAHalf) {
  const OdometryParams params;
  double squares = 0.0;
  const int runs = 400;
  for (std::uint64_t seed = 0; seed < runs; ++seed) {
    OdometryModel model(params, RandomStream(seed, "odometry"), {});
    Odometry last;
    for (int i = 1; i <= 360; ++i) last = model.update({}, {0, 0, wrap_angle(radians(i))});
    squares += last.T_odom_base.yaw_rad * last.T_odom_base.yaw_rad;
  }
  const double expected = std::hypot(params.yaw_scale_sigma * 2.0 * std::numbers::pi, params.yaw_drift_per_turn_rad);
  EXPECT_NEAR(std::sqrt(squares / runs), expected, 0.15 * expected);
  EXPECT_LT(degrees(expected), 2.0);
  EXPECT_GT(degrees(expected), 1.0);
}

}  // namespace
}  // namespace amiss::sim
