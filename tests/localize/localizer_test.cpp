#include "localize/localizer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/result.hpp"
#include "localize/flat.hpp"

namespace amiss::localize {
namespace {

using testing::Drive;
using testing::Flat;

struct Errors {
  double rms_m = 0.0, rms_rad = 0.0, max_m = 0.0;
  double converged_part = 0.0;
};

/// The map's frame is the world's.
Pose2<Map, Base> in_map(const Pose2<World, Base>& truth) { return {truth.x_m, truth.y_m, truth.yaw_rad}; }

Errors follow(const Drive& drive, const FloorGrid& map, std::uint64_t seed) {
  Localizer localizer(map, in_map(drive.steps.front().truth), {}, {}, RandomStream(seed, "localizer"));
  double sum_m = 0.0, sum_rad = 0.0;
  Errors errors;
  for (const Drive::Step& step : drive.steps) {
    const PoseEstimate estimate =
        localizer.update(step.odometry, step.has_scan ? &step.scan : nullptr, testing::laser_mount());
    const double off_m = (estimate.T_map_base.position() - step.truth.position()).norm();
    const double off_rad = wrap_angle(estimate.T_map_base.yaw_rad - step.truth.yaw_rad);
    sum_m += off_m * off_m;
    sum_rad += off_rad * off_rad;
    errors.max_m = std::max(errors.max_m, off_m);
    errors.converged_part += estimate.converged ? 1.0 : 0.0;
  }
  const auto n = static_cast<double>(drive.steps.size());
  errors.rms_m = std::sqrt(sum_m / n);
  errors.rms_rad = std::sqrt(sum_rad / n);
  errors.converged_part /= n;
  return errors;
}

class LocalizerSeeds : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(LocalizerSeeds, StaysWithinTwoCentimetresInAFurnishedFlat) {
  const Flat flat = Flat::furnished();
  const Errors errors = follow(drive(flat, testing::tour(), GetParam()), flat.grid(), GetParam());
  RecordProperty("rms_mm", static_cast<int>(1000.0 * errors.rms_m));
  EXPECT_LT(errors.rms_m, 0.02);
  EXPECT_LT(errors.rms_rad, radians(0.5));
  EXPECT_LT(errors.max_m, 0.08);
  EXPECT_GT(errors.converged_part, 0.99);
}

TEST_P(LocalizerSeeds, IsRobustToThingsThatAreNotInTheMap) {
  const Flat flat = Flat::furnished();
  Flat today = flat;
  today.box({2.9, 3.9}, {3.3, 4.2});
  today.box({5.4, 1.2}, {5.7, 1.4});
  today.box({8.9, 3.8}, {9.2, 4.2});
  today.box({6.0, 7.0}, {6.2, 7.3});
  today.box({3.0, 7.2}, {3.6, 7.6});
  const Errors errors = follow(drive(today, testing::tour(), GetParam()), flat.grid(), GetParam());
  EXPECT_LT(errors.rms_m, 0.03);
  EXPECT_LT(errors.rms_rad, radians(0.7));
  EXPECT_GT(errors.converged_part, 0.95);
}

INSTANTIATE_TEST_SUITE_P(Seeds, LocalizerSeeds, ::testing::Values(1, 2, 3, 17));

TEST(Localizer, IsAFunctionOfItsInputs) {
  const Flat flat = Flat::furnished();
  const FloorGrid map = flat.grid();
  const Drive way = drive(flat, {{3.2, 2.0}, {4.8, 1.95}}, 4);
  Localizer first(map, in_map(way.steps.front().truth), {}, {}, RandomStream(9, "localizer"));
  Localizer second(map, in_map(way.steps.front().truth), {}, {}, RandomStream(9, "localizer"));
  for (const Drive::Step& step : way.steps) {  // in turn: neither disturbs the other
    const LaserScan* scan = step.has_scan ? &step.scan : nullptr;
    const PoseEstimate a = first.update(step.odometry, scan, testing::laser_mount());
    const PoseEstimate b = second.update(step.odometry, scan, testing::laser_mount());
    ASSERT_EQ(a.T_map_base.x_m, b.T_map_base.x_m);
    ASSERT_EQ(a.T_map_base.y_m, b.T_map_base.y_m);
    ASSERT_EQ(a.T_map_base.yaw_rad, b.T_map_base.yaw_rad);
    ASSERT_EQ(a.covariance, b.covariance);
  }
}

TEST(Localizer, SaysWhenItWasCarriedAway) {
  const Flat flat = Flat::furnished();
  const FloorGrid map = flat.grid();
  const Drive here = drive(flat, {{3.2, 2.0}, {3.6, 1.95}}, 5);
  Localizer localizer(map, in_map(here.steps.front().truth), {}, {}, RandomStream(5, "localizer"));
  for (const Drive::Step& step : here.steps) {
    (void)localizer.update(step.odometry, step.has_scan ? &step.scan : nullptr, testing::laser_mount());
  }
  ASSERT_TRUE(localizer.estimate().converged);
  RandomStream random(5, "carried");
  const Odometry odometry = here.steps.back().odometry;
  const LaserScan elsewhere = testing::scan_from(flat, {9.0, 6.0, 2.0}, odometry.stamp, random);
  PoseEstimate estimate;
  for (int i = 0; i < 3; ++i) estimate = localizer.update(odometry, &elsewhere, testing::laser_mount());
  EXPECT_FALSE(estimate.converged);
  localizer.relocalize({9.1, 6.1, 1.9}, {0.2, radians(10.0)});
  EXPECT_FALSE(localizer.estimate().converged);
  for (int i = 0; i < 20; ++i) estimate = localizer.update(odometry, &elsewhere, testing::laser_mount());
  EXPECT_TRUE(estimate.converged);
  EXPECT_LT((estimate.T_map_base.position() - Eigen::Vector2d(9.0, 6.0)).norm(), 0.04);
  EXPECT_LT(std::abs(wrap_angle(estimate.T_map_base.yaw_rad - 2.0)), radians(1.0));
}

/// Carried from one room to the other, then standing there for `scans`.
PoseEstimate carried(const LocalizerParams& params, int scans, LocalizationEvidence& evidence) {
  const Flat flat = Flat::furnished();
  Localizer localizer(flat.grid(), {3.2, 2.0, 0.5}, {}, params, RandomStream(5, "localizer"));
  RandomStream random(5, "carried");
  const LaserScan here = testing::scan_from(flat, {3.2, 2.0, 0.5}, Stamp{}, random);
  for (int i = 0; i < 10; ++i) (void)localizer.update({}, &here, testing::laser_mount());
  EXPECT_TRUE(localizer.estimate().converged);
  PoseEstimate estimate;
  for (int i = 0; i < scans; ++i) {
    const LaserScan elsewhere = testing::scan_from(flat, {9.0, 6.0, 2.0}, Stamp{}, random);
    estimate = localizer.update({}, &elsewhere, testing::laser_mount());
    EXPECT_TRUE(i >= 2 || !estimate.converged) << i;
  }
  evidence = localizer.evidence();
  return estimate;
}

TEST(Localizer, FindsItselfAgainWhenItWasCarriedAway) {
  LocalizationEvidence evidence;
  const PoseEstimate estimate = carried({}, 10, evidence);
  EXPECT_TRUE(estimate.converged);
  EXPECT_EQ(evidence.relocalizations, 1);
  EXPECT_LT((estimate.T_map_base.position() - Eigen::Vector2d(9.0, 6.0)).norm(), 0.04);
  EXPECT_LT(std::abs(wrap_angle(estimate.T_map_base.yaw_rad - 2.0)), radians(1.0));
}

TEST(Localizer, DoesNotFindItselfAgainWithoutTheMapsSearch) {
  LocalizerParams params;
  params.relocalize = false;
  LocalizationEvidence evidence;
  const PoseEstimate estimate = carried(params, 50, evidence);
  EXPECT_EQ(evidence.relocalizations, 0);
  EXPECT_GT((estimate.T_map_base.position() - Eigen::Vector2d(9.0, 6.0)).norm(), 0.3);
}

TEST(Localizer, AScanThatMovesThePoseIsNotBelievedAtOnce) {
  const Flat flat = Flat::furnished();
  Localizer localizer(flat.grid(), {3.2, 2.0, 0.5}, {}, {}, RandomStream(5, "localizer"));
  RandomStream random(5, "slip");
  const LaserScan here = testing::scan_from(flat, {3.2, 2.0, 0.5}, Stamp{}, random);
  for (int i = 0; i < 10; ++i) (void)localizer.update({}, &here, testing::laser_mount());
  const LaserScan slipped = testing::scan_from(flat, {3.3, 2.0, 0.5}, Stamp{}, random);
  EXPECT_FALSE(localizer.update({}, &slipped, testing::laser_mount()).converged);
  EXPECT_GT(localizer.evidence().correction_m, 0.04);
  PoseEstimate estimate;
  for (int i = 0; i < 10; ++i) estimate = localizer.update({}, &slipped, testing::laser_mount());
  EXPECT_TRUE(estimate.converged);
  EXPECT_NEAR(estimate.T_map_base.x_m, 3.3, 0.03);
}

TEST(Localizer, OdometryMovesThePoseBetweenScans) {
  const Flat flat = Flat::furnished();
  Localizer localizer(flat.grid(), {3.2, 2.0, 0.5}, {}, {}, RandomStream(6, "localizer"));
  (void)localizer.update({Stamp{}, {1.0, 2.0, 0.1}}, nullptr, testing::laser_mount());
  const PoseEstimate moved =
      localizer.update({Stamp{}, {1.0 + std::cos(0.1), 2.0 + std::sin(0.1), 0.3}}, nullptr, testing::laser_mount());
  EXPECT_NEAR(moved.T_map_base.x_m, 3.2 + std::cos(0.5), 1e-9);
  EXPECT_NEAR(moved.T_map_base.y_m, 2.0 + std::sin(0.5), 1e-9);
  EXPECT_NEAR(moved.T_map_base.yaw_rad, 0.7, 1e-9);
  EXPECT_FALSE(moved.converged);
  const Pose2<Map, Base> then = localizer.T_map_odom() * Pose2<Odom, Base>{1.0, 2.0, 0.1};
  EXPECT_NEAR(then.x_m, 3.2, 1e-9);
}

TEST(Localizer, RefusesAMapWithoutWalls) {
  const FloorGrid empty(0.05, {0.0, 0.0}, 20, 20, Occupancy::kFree);
  EXPECT_THROW(Localizer(empty, {}, {}, {}, RandomStream(1, "localizer")), ArgumentError);
}

TEST(Localizer, SurvivesScansWithoutReturns) {
  const Flat flat = Flat::furnished();
  Localizer localizer(flat.grid(), {3.2, 2.0, 0.5}, {}, {}, RandomStream(6, "localizer"));
  LaserScan nothing;
  nothing.angle_step_rad = 0.01;
  nothing.max_range_m = 20.0;
  nothing.ranges_m.assign(300, std::nanf(""));
  const PoseEstimate estimate = localizer.update({Stamp{}, {}}, &nothing, testing::laser_mount());
  EXPECT_FALSE(estimate.converged);
  EXPECT_TRUE(std::isfinite(estimate.T_map_base.x_m));
  nothing.ranges_m.clear();
  EXPECT_TRUE(std::isfinite(localizer.update({Stamp{}, {}}, &nothing, testing::laser_mount()).T_map_base.x_m));
}

}  // namespace
}  // namespace amiss::localize
