#include "video/chase.hpp"

#include <gtest/gtest.h>

#include "video/told_run.hpp"

namespace amiss::video {
namespace {

TEST(Chase, TimesSpanTheRun) {
  const FilmTimes times{4.0, 10, 0.0, 10.0};
  EXPECT_EQ(times.count(), 26U);
  EXPECT_DOUBLE_EQ(times.at_s(0), 0.0);
  EXPECT_DOUBLE_EQ(times.at_s(25), 10.0);
  EXPECT_EQ((FilmTimes{100.0, 1, 3.0, 10.0}.count()), 1U);
}

TEST(Chase, StaysBehindAndAboveTheRobotAndLooksAtIt) {
  const page::Story story = test::told_run();
  const FilmTimes times{1.0, 10, 0.0, 10.0};
  const auto cameras = chase(story, times);
  ASSERT_EQ(cameras.size(), times.count());
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Transform<World, Base> T_world_base =
        story.place.T_world_map * page::pose_at(story, times.at_s(i)).truth.lift();
    const Eigen::Vector3d eye = (T_world_base.inverse().T * cameras[i].position());
    EXPECT_LT(eye.x(), -1.5) << i;
    EXPECT_NEAR(eye.y(), 0.0, 1e-6) << i;
    EXPECT_GT(eye.z(), 2.0) << i;
    const Eigen::Vector3d robot = cameras[i].inverse().T * T_world_base.position();
    EXPECT_GT(robot.z(), 2.0) << "before the camera";
    EXPECT_LT(robot.head<2>().norm() / robot.z(), 0.4) << "near the middle of the picture";
  }
}

}  // namespace
}  // namespace amiss::video
