#include "segment/internal/extent.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"

namespace amiss::segment::internal {
namespace {

/// Points on the top and the sides of a box on the plane z = -d.
std::vector<Eigen::Vector3f> points_on_box(const Eigen::Vector3d& centre, const Eigen::Vector3d& size, double yaw_rad,
                                           double noise_m) {
  RandomStream random(1, "box");
  std::vector<Eigen::Vector3f> points;
  const Eigen::AngleAxisd turn(yaw_rad, Eigen::Vector3d::UnitZ());
  for (int i = 0; i < 4000; ++i) {
    Eigen::Vector3d p(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    if (i % 2 == 0) p.z() = 0.5;
    if (i % 2 != 0) p[i % 4 / 2] = i % 8 < 4 ? 0.5 : -0.5;
    const Eigen::Vector3d noise = noise_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    points.push_back((centre + turn * p.cwiseProduct(size) + noise).cast<float>());
  }
  return points;
}

RC_GTEST_PROP(Extent, IsTheBoxThatThePointsLieOn, ()) {
  const auto between = [](int low, int high) { return *rc::gen::inRange(low, high + 1); };
  const Eigen::Vector3d size(between(150, 300) / 1000.0, between(30, 120) / 1000.0, between(30, 300) / 1000.0);
  const double yaw_rad = between(-15, 15) / 10.0;
  const Plane ground{Eigen::Vector3d::UnitZ(), 0.012, 100};
  const Eigen::Vector3d centre(between(-30, 30) / 10.0, between(-30, 30) / 10.0, -0.012 + size.z() / 2.0);
  const Extent extent = extent_of(points_on_box(centre, size, yaw_rad, 0.002), ground);
  RC_ASSERT((extent.centre_map - centre).norm() < 0.008);
  RC_ASSERT((extent.size_m - size).cwiseAbs().maxCoeff() < 0.02);
  RC_ASSERT(std::abs(std::sin(extent.yaw_rad - yaw_rad)) < 0.08);
}

TEST(Extent, StandsOnATiltedGround) {
  const Plane ground{Eigen::Vector3d(0.1, 0.0, 1.0).normalized(), 0.0, 100};
  const Eigen::Vector3d centre(1.0, 0.0, -0.1 + 0.05);
  const Extent extent = extent_of(points_on_box(centre, {0.1, 0.1, 0.1}, 0.0, 0.0), ground);
  EXPECT_NEAR(extent.centre_map.z(), centre.z(), 0.01);
}

}  // namespace
}  // namespace amiss::segment::internal
