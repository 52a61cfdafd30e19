#include "world/bounds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace amiss::world {
namespace {

Eigen::Isometry3d some_pose() {
  const auto number = [](int limit) { return *rc::gen::inRange(-limit, limit) / 1000.0; };
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translate(Eigen::Vector3d(number(5000), number(5000), number(5000)));
  T.rotate(
      Eigen::AngleAxisd(number(3141), Eigen::Vector3d(number(1000), number(1000), number(1000) + 2.0).normalized()));
  return T;
}

/// Slow and obvious: the box around many points of the surface.
Eigen::AlignedBox3d of_points(const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d& T) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(T * p);
  return box;
}

void expect_same(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b, double tolerance) {
  RC_ASSERT((a.min() - b.min()).cwiseAbs().maxCoeff() < tolerance);
  RC_ASSERT((a.max() - b.max()).cwiseAbs().maxCoeff() < tolerance);
}

RC_GTEST_PROP(BoundsProperty, BoxAgreesWithItsCorners, ()) {
  const Eigen::Vector3d size(0.4, 1.0, 2.5);
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(size.cwiseProduct(
        Eigen::Vector3d((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5, (i & 4) != 0 ? 0.5 : -0.5)));
  }
  const Eigen::Isometry3d T = some_pose();
  expect_same(bounds(Box{size}, T), of_points(corners, T), 1e-9);
}

RC_GTEST_PROP(BoundsProperty, CylinderAgreesWithPointsOfItsRims, ()) {
  std::vector<Eigen::Vector3d> rims;
  for (int i = 0; i < 3600; ++i) {
    const double angle = i * std::numbers::pi / 1800.0;
    for (const double z : {-0.75, 0.75}) rims.emplace_back(0.3 * std::cos(angle), 0.3 * std::sin(angle), z);
  }
  const Eigen::Isometry3d T = some_pose();
  expect_same(bounds(Cylinder{0.3, 1.5}, T), of_points(rims, T), 1e-5);
}

RC_GTEST_PROP(BoundsProperty, MeshAgreesWithItsScaledVertices, ()) {
  Mesh mesh;
  std::vector<Eigen::Vector3d> scaled;
  const Eigen::Vector3d scale(2.0, 0.5, -1.0);
  for (const Eigen::Vector3f& v : {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(-1, 0.5F, 4)}) {
    mesh.vertices.push_back(v);
    scaled.push_back(scale.cwiseProduct(v.cast<double>()));
  }
  const Eigen::Isometry3d T = some_pose();
  expect_same(bounds(MeshInstance{std::make_shared<const Mesh>(mesh), scale}, T), of_points(scaled, T), 1e-5);
}

TEST(BoundsTest, SphereAndPlane) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translate(Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(bounds(Sphere{0.5}, T)
                  .isApprox(Eigen::AlignedBox3d(Eigen::Vector3d(0.5, 1.5, 2.5), Eigen::Vector3d(1.5, 2.5, 3.5))));
  const Eigen::AlignedBox3d wall = bounds(Plane{Eigen::Vector3d::UnitX(), {2.0, 4.0}}, T);
  EXPECT_NEAR(wall.sizes().x(), 0.0, 1e-12);
  EXPECT_NEAR(wall.sizes().y() * wall.sizes().z(), 8.0, 1e-9);
}

TEST(BoundsTest, BodyUsesCollisionsAndElseVisuals) {
  Body body;
  body.pose.T.translate(Eigen::Vector3d(1, 0, 0));
  EXPECT_TRUE(bounds_in_world(body).isEmpty());
  body.visuals.push_back({Sphere{2.0}, Eigen::Isometry3d::Identity(), {}});
  EXPECT_NEAR(bounds_in_world(body).sizes().x(), 4.0, 1e-12);
  body.collisions.push_back({Sphere{1.0}, Eigen::Isometry3d::Identity(), {}});
  EXPECT_NEAR(bounds_in_world(body).sizes().x(), 2.0, 1e-12);
  EXPECT_NEAR(bounds_in_world(body).center().x(), 1.0, 1e-12);
}

}  // namespace
}  // namespace amiss::world
