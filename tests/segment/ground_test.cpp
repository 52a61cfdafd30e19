#include "segment/internal/ground.hpp"

#include <gtest/gtest.h>

#include "segment/scene.hpp"

namespace amiss::segment::internal {
namespace {

const Cylinder kCrop{Eigen::Vector2d(0.95, 0.0), 0.35, -0.15, 0.4};

TEST(Ground, IsTheFloorAlsoWhereMostOfTheCropIsAThing) {
  const auto view = testing::look({testing::box_at(0.95, 0.0, {0.45, 0.4, 0.03}, 0.2, {200, 0, 0})}, -0.75, 1);
  const auto ground = ground_of(window_of(view.frame, view.T_map_camera, kCrop, 3.5), {});
  ASSERT_TRUE(ground.has_value());
  EXPECT_NEAR(height_above(*ground, Eigen::Vector3f(0.95F, 0.0F, static_cast<float>(testing::kFloorZ))), 0.0, 0.004);
  EXPECT_GT(ground->normal_map.z(), 0.999);
}

TEST(Ground, IsNotAWall) {
  const auto view = testing::look({testing::box_at(0.7, 0.0, {0.1, 3.0, 2.0}, 0.0, {200, 200, 200})}, -0.3, 1);
  EXPECT_FALSE(ground_of(window_of(view.frame, view.T_map_camera, {{0.7, 0.0}, 0.3, 0.02, 1.5}, 3.5), {}).has_value());
}

TEST(Ground, IsTheSameEachTime) {
  const auto view = testing::look({}, -0.75, 2);
  const Window window = window_of(view.frame, view.T_map_camera, kCrop, 3.5);
  EXPECT_EQ(ground_of(window, {})->d_m, ground_of(window, {})->d_m);
}

}  // namespace
}  // namespace amiss::segment::internal
