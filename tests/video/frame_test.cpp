#include "video/frame.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "video/told_run.hpp"

namespace amiss::video {
namespace {

struct FrameOf : testing::Test {
  page::Story story = test::told_run();
  ThirdPerson view;

  FrameOf() {
    const CameraIntrinsics camera = third_person_camera();
    const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    view.picture.intrinsics = camera;
    view.picture.colour.assign(pixels, {90, 90, 90});
    view.picture.depth_m.assign(pixels, std::numeric_limits<float>::quiet_NaN());  // nothing hides anything
    const Eigen::Vector3d p = story.place.T_world_map.T * Eigen::Vector3d(0.0, 0.0, 0.0);
    view.T_world_camera = sim::look_at({p + Eigen::Vector3d(0.0, 0.0, 6.0)}, {p});
  }
  static Rgb at(const std::vector<Rgb>& frame, int u, int v) {
    return frame[static_cast<std::size_t>(v) * kFrameWidth + static_cast<std::size_t>(u)];
  }
  /// Mean place of the pixels of a box whose colour satisfies `is`; none: no such pixel.
  template <class Is>
  static std::optional<Eigen::Vector2d> middle_of(const std::vector<Rgb>& frame, int u0, int v0, int u1, int v1,
                                                  Is is) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int count = 0;
    for (int v = v0; v < v1; ++v) {
      for (int u = u0; u < u1; ++u) {
        if (!is(at(frame, u, v))) continue;
        sum += Eigen::Vector2d(u, v);
        ++count;
      }
    }
    if (count == 0) return std::nullopt;
    return sum / count;
  }
};

TEST_F(FrameOf, MapIsNotMirroredAndShowsTheRobotWhereItIs) {
  const auto frame = compose(story, 10.0, view, "");
  ASSERT_EQ(frame.size(), static_cast<std::size_t>(kFrameWidth) * kFrameHeight);
  const auto white = [](const Rgb& p) { return p.r > 225 && p.g > 225 && p.b > 225; };
  const auto green = [](const Rgb& p) { return p.r < 30 && p.g > 140 && p.b > 90; };
  const auto wall = [](const Rgb& p) { return p == Rgb{174, 182, 190}; };
  const auto robot = middle_of(frame, 864, 332, 1264, 604, white), mug = middle_of(frame, 864, 332, 1264, 604, green),
             far_wall = middle_of(frame, 864, 332, 1264, 604, wall);
  ASSERT_TRUE(robot && mug && far_wall);
  const double scale = (272 - 20) / 6.0;  // 6 m high, pixels a metre
  EXPECT_NEAR(robot->x() - mug->x(), 1.0 * scale, 3.0) << "the robot is 1 m further along x: to the right";
  EXPECT_NEAR(robot->y() - mug->y(), 1.0 * scale, 3.0) << "and 1 m lower";
  EXPECT_LT(far_wall->y(), mug->y()) << "y is up";
}

TEST_F(FrameOf, MarksLieOnTheFloorWhereTheyAre) {
  // Seen from straight above, up in the picture is y of the world; the map is turned by 1 rad.
  const auto orange = [](const Rgb& p) { return p.r > 200 && p.g > 130 && p.g < 180 && p.b < 40; };
  const auto ring = middle_of(compose(story, 3.0, view, ""), 16, 60, 848, 604, orange);
  ASSERT_TRUE(ring);
  const Eigen::Vector3d p =
      view.T_world_camera.inverse().T * (story.place.T_world_map.T * Eigen::Vector3d(1.0, 1.0, 0.0));
  const CameraIntrinsics c = third_person_camera();
  EXPECT_NEAR(ring->x(), 16 + c.fx * p.x() / p.z() + c.cx, 2.0);
  EXPECT_NEAR(ring->y(), 16 + c.fy * p.y() / p.z() + c.cy, 2.0);
}

TEST_F(FrameOf, WhatStandsBeforeAMarkHidesIt) {
  const auto orange = [](const Rgb& p) { return p.r > 200 && p.g > 130 && p.g < 180 && p.b < 40; };
  view.picture.depth_m.assign(view.picture.depth_m.size(), 2.0F);
  EXPECT_FALSE(middle_of(compose(story, 3.0, view, ""), 16, 60, 848, 604, orange));
}

TEST_F(FrameOf, TimelineFillsUp) {
  const auto filled = [](const Rgb& p) { return p == Rgb{86, 180, 233}; };
  const auto early = middle_of(compose(story, 2.5, view, ""), 16, 670, 1264, 678, filled),
             late = middle_of(compose(story, 10.0, view, ""), 16, 670, 1264, 678, filled);
  ASSERT_TRUE(early && late);
  EXPECT_NEAR(early->x(), 32 + 1216 * 0.125, 8.0);
  EXPECT_NEAR(late->x(), 32 + 1216 * 0.5, 8.0);
}

TEST_F(FrameOf, OfAScriptedRunOnlyWhatWasFoundIsCounted) {
  const auto told = compose(story, 7.0, view, "");
  story.notes.push_back({8.0, {page::Note::Kind::kScript, "anna walks"}});
  const auto scripted = compose(story, 7.0, view, "");
  int differing = 0;  // "1 of 1 found", "1 found": the title is shorter
  for (int u = 700; u < 848; ++u) differing += at(told, u, 40) == at(scripted, u, 40) ? 0 : 1;
  EXPECT_GT(differing, 0);
}

TEST_F(FrameOf, LongTextsStayInTheirPlaces) {
  std::string text = "region 7";
  for (int i = 0; i < 40; ++i) text += " and what else there is to be told";
  story.notes = {{1.0, {page::Note::Kind::kFound, text}}};
  const auto before = compose(story, 0.5, view, "");
  const auto after = compose(story, 1.0, view, "");
  const auto green = [](const Rgb& p) { return p.g > p.r + 60 && p.g > p.b + 20; };
  const auto words = middle_of(after, 16, 620, 1264, 668, green);
  ASSERT_TRUE(words);
  EXPECT_NEAR(words->x(), 0.5 * (182 + 1190), 40.0) << "from the clock to the length of the run";
  EXPECT_FALSE(middle_of(after, 1200, 620, 1280, 660, green)) << "the length of the run stays readable";
  EXPECT_EQ(at(before, 1270, 640), at(after, 1270, 640)) << "nothing beyond the strip";
  story.world = std::string(300, 'w');
  const auto bright = [](const Rgb& p) { return p.r > 200 && p.g > 200 && p.b > 200; };
  EXPECT_FALSE(middle_of(compose(story, 1.0, view, ""), 745, 16, 848, 50, bright)) << "what was found stays readable";
}

TEST_F(FrameOf, IsAFunctionOfItsInput) { EXPECT_EQ(compose(story, 3.0, view, ""), compose(story, 3.0, view, "")); }

TEST_F(FrameOf, RefusesWhatIsNoPicture) {
  EXPECT_THROW(compose(story, 3.0, view, "no picture"), InputError);
  view.picture.intrinsics.width = 640;
  EXPECT_THROW(compose(story, 3.0, view, ""), ArgumentError);
}

}  // namespace
}  // namespace amiss::video
