#include "view/head.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"
#include "view/test_head.hpp"

namespace amiss::view {
namespace {

RC_GTEST_PROP(LookAt, BringsThePointIntoTheMiddleOfTheImage, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "head");
  const Head head = test_head();
  const double x = random.uniform(-5, 5), y = random.uniform(-5, 5), yaw = random.uniform(-3.1, 3.1);
  const Pose2<Map, Base> pose{x, y, yaw};
  const double range = random.uniform(0.4, 4.0), bearing = random.uniform(-1.0, 1.0);
  const Eigen::Vector3d point(x + range * std::cos(yaw + bearing), y + range * std::sin(yaw + bearing),
                              random.uniform(0.0, 1.2));
  const robot::HeadState state = look_at(head, pose, point);
  const Eigen::Vector2d pixel = pixel_of(head, pose, state, point);
  RC_ASSERT(std::abs(pixel.x() - 319.5) < 0.5);
  RC_ASSERT(std::abs(pixel.y() - 239.5) < 0.5);
}

TEST(LookAt, StaysWithinTheLimitsOfTheTilt) {
  Head head = test_head();
  head.tilt_min_rad = -0.3;
  EXPECT_EQ(look_at(head, {0, 0, 0}, {0.3, 0, 0}).tilt_rad, -0.3);
}

}  // namespace
}  // namespace amiss::view
