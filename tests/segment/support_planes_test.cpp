#include "segment/support_planes.hpp"

#include <gtest/gtest.h>

#include "segment/normals.hpp"

namespace amiss::segment {
namespace {

struct Surfaces {
  std::vector<Eigen::Vector3f> points;
  std::vector<SemanticClass> labels;

  /// A rectangle of points 1 cm apart with noise of 2 mm; `slope` is its rise along x.
  void add(float x0, float y0, float z, float width, float depth, float slope, SemanticClass label) {
    RandomStream random(3, "noise" + std::to_string(points.size()));
    for (float x = 0.0F; x < width; x += 0.01F) {
      for (float y = 0.0F; y < depth; y += 0.01F) {
        const auto noise = static_cast<float>(random.uniform(-0.002, 0.002));
        points.emplace_back(x0 + x, y0 + y, z + slope * x + noise);
        labels.push_back(label);
      }
    }
  }
  [[nodiscard]] std::vector<SupportPlane> planes(bool labelled) const {
    const auto normals = upward_normals(points, PointGrid(points, 0.02F), 0.03F);
    return support_planes(points, normals, labelled ? labels : std::vector<SemanticClass>{}, {},
                          RandomStream(1, "planes"));
  }
};

TEST(SupportPlanes, AreFoundFromBelowWithTheirHeights) {
  Surfaces s;
  s.add(0, 0, 0.7F, 0.8F, 0.5F, 0.0F, SemanticClass::kTable);
  s.add(-1, -1, 0.0F, 3.0F, 1.0F, 0.02F, SemanticClass::kFloor);  // warped by a reconstruction
  s.add(0, 2, 0.4F, 0.5F, 0.5F, 0.3F, SemanticClass::kTable);     // a ramp of 17 degrees carries nothing
  const auto planes = s.planes(false);
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_NEAR(planes[1].height_m, 0.7, 0.001);
  EXPECT_NEAR(planes[1].area_m2, 0.4, 0.04);
  EXPECT_GT(planes[1].inliers.size(), 3900U);
  EXPECT_NEAR(planes[0].above({1.0F, -0.5F, 0.14F}), 0.1, 0.002);
  EXPECT_TRUE(planes[1].footprint.contains(0.4F, 0.2F));
}

TEST(SupportPlanes, TwoHeightsInOneClusterAreTwoPlanes) {
  Surfaces s;
  s.add(0, 0, 0.70F, 0.5F, 0.5F, 0.0F, SemanticClass::kDesk);
  s.add(0.5F, 0, 0.725F, 0.5F, 0.5F, 0.0F, SemanticClass::kDesk);
  const auto planes = s.planes(true);
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_NEAR(planes[0].height_m, 0.70, 0.002);
  EXPECT_NEAR(planes[1].height_m, 0.725, 0.002);
}

TEST(SupportPlanes, OnlyRelevantClassesCarry) {
  Surfaces s;
  s.add(0, 0, 2.4F, 1.0F, 1.0F, 0.0F, SemanticClass::kWall);
  s.add(0, 0, 0.7F, 0.5F, 0.5F, 0.0F, SemanticClass::kCounter);
  EXPECT_EQ(s.planes(true).size(), 1U);
  EXPECT_EQ(s.planes(false).size(), 2U);
}

}  // namespace
}  // namespace amiss::segment
