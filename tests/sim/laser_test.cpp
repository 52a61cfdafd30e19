#include "sim/laser.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <cmath>

#include "sim/internal/segment_grid.hpp"
#include "sim/physics.hpp"
#include "sim/rooms.hpp"

namespace amiss::sim {
namespace {

constexpr double kHeight_m = 0.184;

world::World furnished() {
  world::World world = test::room(6, 5);
  world.bodies.push_back(test::block("cupboard", {0.6, 0.4, 1.0}, {3, 4.8, 0.5}));
  world.bodies.push_back(test::block("turned", {0.5, 0.3, 0.6}, {4.5, 1.5, 0.3}));
  world.bodies.back().pose.T.rotate(Eigen::AngleAxisd(0.6, Eigen::Vector3d(0.2, 0.1, 1).normalized()));
  world.bodies.push_back(test::block("table_top", {1.2, 0.8, 0.04}, {1.5, 3, 0.72}));
  for (int leg = 0; leg < 4; ++leg) {
    world.bodies.push_back(
        test::block("leg" + std::to_string(leg), {0.05, 0.05, 0.7}, {1.0 + (leg % 2), 2.7 + 0.6 * (leg / 2), 0.35}));
  }
  world.bodies.push_back(test::body("can", world::Cylinder{0.05, 0.3}, {2.5, 2.0, 0.15}, false));
  world.bodies.push_back(test::body("ball", world::Sphere{0.25}, {4, 3, 0.25}, false));
  return world;
}

LaserScanner scanner_of(const world::World& world) {
  LaserScanner scanner(world, kHeight_m, {});
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!world.bodies[i].is_static) scanner.set_moving(i, world.bodies[i], world.bodies[i].pose);
  }
  return scanner;
}

RC_GTEST_PROP(LaserScanner, AgreesWithRaysThroughTheShapes, ()) {
  const world::World world = furnished();
  const LaserScanner scanner = scanner_of(world);
  const Physics oracle(world);
  const Pose2<amiss::World, Laser> at{*rc::gen::inRange(300, 2200) * 1e-3, *rc::gen::inRange(300, 2300) * 1e-3,
                                      *rc::gen::inRange(-3141, 3141) * 1e-3};
  const LaserScan scan = scanner.measure({}, at);
  RC_ASSERT(scan.ranges_m.size() == 721U);
  int differing = 0;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double angle = at.yaw_rad + scan.angle_min_rad + static_cast<double>(i) * scan.angle_step_rad;
    const Eigen::Vector3d from(at.x_m, at.y_m, kHeight_m);
    const Eigen::Vector3d to = from + 20.0 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
    const auto hit = oracle.cast_ray({from}, {to});
    RC_ASSERT(hit.has_value());
    // Round things are prisms for the laser: a beam along a surface may pass.
    if (std::abs(hit->range_m - static_cast<double>(scan.ranges_m[i])) > 0.004) ++differing;
  }
  RC_ASSERT(differing <= 8);
}

RC_GTEST_PROP(SegmentGrid, CastsAsTestingEachSegmentDoes, (std::uint64_t seed)) {
  RandomStream random(seed, "segments");
  std::vector<Segment2> segments;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector2d a(random.uniform(-5, 5), random.uniform(-5, 5));
    segments.push_back({a, a + Eigen::Vector2d(random.uniform(-2, 2), random.uniform(-2, 2))});
  }
  segments.push_back({{-5, 1}, {5, 1}});  // along the borders of cells
  segments.push_back({{1, -5}, {1, 5}});
  const internal::SegmentGrid grid(segments);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d origin(random.uniform(-8, 8), random.uniform(-8, 8));
    const double angle = i % 4 == 0 ? 0.5 * std::numbers::pi * (i % 3) : random.uniform(-3.2, 3.2);
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment2& s : segments) nearest = std::min(nearest, internal::hit(s, origin, direction));
    const double cast = grid.cast(origin, direction, 100.0);
    RC_ASSERT(std::isinf(nearest) == std::isinf(cast));
    if (!std::isinf(nearest)) RC_ASSERT(std::abs(nearest - cast) < 1e-9);
  }
}

TEST(LaserScanner, OutOfRangeIsNan) {
  LaserParams params;
  params.max_range_m = 2.0;
  const LaserScanner scanner(test::room(6, 6), kHeight_m, params);
  const LaserScan scan = scanner.measure({}, {3, 0.5, 0});
  EXPECT_TRUE(std::isnan(scan.ranges_m[360]));
  const double down = -0.5 * std::numbers::pi;
  const auto beam = static_cast<std::size_t>(std::lround((down - scan.angle_min_rad) / scan.angle_step_rad));
  EXPECT_NEAR(scan.ranges_m[beam], 0.5, 1e-3);
}

TEST(LaserScanner, GlassIsPassed) {
  world::World world = test::room(6, 6);
  world.bodies.push_back(test::block("pane", {0.02, 6, 2}, {4, 3, 1}));
  world.bodies.back().visuals[0].material.alpha = 0.4F;
  const LaserScanner scanner(world, kHeight_m, {});
  EXPECT_NEAR(scanner.measure({}, {3, 3, 0}).ranges_m[360], 3.0, 1e-6);
}

TEST(LaserScanner, MovedAndRemovedBodiesAreFollowed) {
  world::World world = test::room(6, 6);
  const world::Body crate = test::block("crate", {0.4, 0.4, 0.4}, {4, 3, 0.2}, false);
  LaserScanner scanner(world, kHeight_m, {});
  const Pose2<amiss::World, Laser> at{1, 3, 0};
  scanner.set_moving(9, crate, crate.pose);
  EXPECT_NEAR(scanner.measure({}, at).ranges_m[360], 2.8, 1e-6);
  scanner.set_moving(9, crate, test::at(3, 3, 0.2));
  EXPECT_NEAR(scanner.measure({}, at).ranges_m[360], 1.8, 1e-6);
  scanner.set_moving(9, crate, test::at(3, 3, -0.1));  // below the laser
  EXPECT_NEAR(scanner.measure({}, at).ranges_m[360], 5.0, 1e-6);
  scanner.set_moving(9, crate, test::at(0.5, 3, 0.2));  // behind it, where no beam goes
  EXPECT_NEAR(scanner.measure({}, at).ranges_m[360], 5.0, 1e-6);
  scanner.remove_moving(9);
  EXPECT_NEAR(scanner.measure({}, at).ranges_m[360], 5.0, 1e-6);
}

TEST(LaserScanner, NoiseHasItsDeviationAndNoBias) {
  const LaserScanner scanner(test::room(6, 5), kHeight_m, {});
  RandomStream noise(7, "laser");
  const Pose2<amiss::World, Laser> at{3, 2.5, 0.3};
  const LaserScan exact = scanner.measure({}, at);
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (int scan = 0; scan < 50; ++scan) {
    const LaserScan noisy = scanner.measure({}, at, noise);
    for (std::size_t i = 0; i < noisy.ranges_m.size(); ++i, ++count) {
      const double error = static_cast<double>(noisy.ranges_m[i] - exact.ranges_m[i]);
      sum += error;
      squares += error * error;
    }
  }
  EXPECT_NEAR(sum / count, 0.0, 2e-4);
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 2e-4);
}

}  // namespace
}  // namespace amiss::sim
