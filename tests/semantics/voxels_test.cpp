#include "semantics/voxels.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/result.hpp"

namespace amiss::semantics {
namespace {

TEST(Voxels, MeansOfTheirPoints) {
  const Cloud<Map> cloud{{{0.001F, 0.001F, 0.001F}, {0.003F, 0.005F, 0.009F}, {-0.01F, 0, 0}},
                         {{255, 255, 255}, {0, 0, 0}, {255, 0, 0}},
                         {{0, 0, 1}, {0, 1, 0}, {0, 0, 1}}};
  const Voxels voxels = voxels_of(cloud, 0.02);
  ASSERT_EQ(voxels.size(), 2U);
  EXPECT_EQ(voxels.of_point, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_LT((voxels.positions[0] - Eigen::Vector3f(0.002F, 0.003F, 0.005F)).norm(), 1e-6F);
  EXPECT_NEAR(voxels.normals[0].norm(), 1.0F, 1e-6F);
  EXPECT_NEAR(voxels.normals[0].y(), voxels.normals[0].z(), 1e-6F);
  EXPECT_NEAR(voxels.colours[0].x(), 0.5F, 1e-3F);
  EXPECT_EQ(voxels.at({0, 0, 0}), 0U);
  EXPECT_EQ(voxels.at({-1, 0, 0}), 1U);
  EXPECT_EQ(voxels.at({7, 0, 0}), Voxels::kNone);
}

TEST(Voxels, LabOfKnownColours) {
  const auto is = [](const Rgb& rgb, double l, double a, double b) {
    const Eigen::Vector3f lab = lab_of(rgb) * 100.0F;
    EXPECT_NEAR(lab.x(), l, 0.5);
    EXPECT_NEAR(lab.y(), a, 0.7);
    EXPECT_NEAR(lab.z(), b, 0.7);
  };
  is({255, 255, 255}, 100, 0, 0);
  is({0, 0, 0}, 0, 0, 0);
  is({255, 0, 0}, 53.2, 80.1, 67.2);
  is({0, 0, 255}, 32.3, 79.2, -107.9);
}

TEST(Voxels, PointsThatAreNotFiniteHaveNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Voxels voxels = voxels_of({{{nan, 0, 0}, {1e20F, 0, 0}, {1, 1, 1}}, {}, {}}, 0.02);
  EXPECT_EQ(voxels.of_point, (std::vector<std::uint32_t>{Voxels::kNone, Voxels::kNone, 0}));
  EXPECT_TRUE(voxels.normals[0].isZero());
}

TEST(Voxels, ColoursMustBeAsManyAsPoints) {
  EXPECT_THROW((void)voxels_of({{{0, 0, 0}}, {{}, {}}, {}}, 0.02), ArgumentError);
}

}  // namespace
}  // namespace amiss::semantics
