#include "segment/normals.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace amiss::segment {
namespace {

TEST(Normals, StandOnPlanesAndPointUp) {
  for (const Eigen::Vector3f& tilt : {Eigen::Vector3f(0, 0, 1), Eigen::Vector3f(0.3F, -0.2F, 0.8F),
                                      Eigen::Vector3f(1, 0, 0.001F), Eigen::Vector3f(0.2F, 0.9F, -0.4F)}) {
    const Eigen::Vector3f normal = tilt.normalized();
    const Eigen::Vector3f u = normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<Eigen::Vector3f> points;
    for (int a = -5; a <= 5; ++a) {
      for (int b = -5; b <= 5; ++b)
        points.emplace_back(0.01F * (static_cast<float>(a) * u + static_cast<float>(b) * v));
    }
    const auto normals = upward_normals(points, PointGrid(points, 0.02F), 0.03F);
    ASSERT_EQ(normals.size(), points.size());
    EXPECT_NEAR(std::abs(normals[60].dot(normal)), 1.0F, 1e-4F);
    EXPECT_GE(normals[60].z(), 0.0F);
  }
}

TEST(Normals, AreZeroWhereNothingTells) {
  const std::vector<Eigen::Vector3f> lonely = {{0, 0, 0}, {5, 0, 0}};
  EXPECT_TRUE(upward_normals(lonely, PointGrid(lonely, 0.02F), 0.03F)[0].isZero());
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 20; ++i) line.emplace_back(0.003F * static_cast<float>(i), 0, 0);
  EXPECT_TRUE(upward_normals(line, PointGrid(line, 0.02F), 0.03F)[10].isZero());
}

}  // namespace
}  // namespace amiss::segment
