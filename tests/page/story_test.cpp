#include "page/story.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "page/small_run.hpp"

namespace amiss::page {
namespace {

struct StoryOf : testing::Test {
  test::TemporaryFolder folder;
  History history;
  test::SmallRun run;
  Story told(double seconds_s) {
    run.record(folder.path(), history, seconds_s);
    return read_story(history.lines());
  }
};

TEST_F(StoryOf, TellsWhatWasRecorded) {
  run.place = {"lab", "robot.urdf", {}};
  run.place.T_world_map.T.translate(Eigen::Vector3d(1.0, 2.0, 0.5));
  run.bodies.push_back({"mug", "mug", {}});
  run.bodies[0].T_map_body.T.translate(Eigen::Vector3d(1.0, 2.0, 0.05));
  run.during = [&](mission::Sinks& sinks, int i) {
    if (i == 60) run.bodies.clear();
    if (i == 60) run.objects[0].found = true;
    const std::vector<segment::Segment> segments(2);
    if (i == 60) sinks.examined({0, run.now, &run.frame, {}, &segments, 0.0, {}});
  };
  const Story story = told(2.0);
  EXPECT_EQ(story.world, "lab");
  EXPECT_EQ(story.place.robot, "robot.urdf");
  EXPECT_EQ(story.outcome, "explored");
  EXPECT_TRUE(story.place.T_world_map.T.isApprox(run.place.T_world_map.T));
  EXPECT_EQ(story.floor, run.floor) << "cell by cell";
  EXPECT_EQ(story.poses.size(), 11U);
  EXPECT_DOUBLE_EQ(story.end_s, 2.0);
  EXPECT_EQ(story.pictures.size(), 3U);
  ASSERT_NE(latest(story.bodies, 1.0), nullptr);
  EXPECT_TRUE(latest(story.bodies, 1.0)->T_map_body.has_value());
  EXPECT_FALSE(latest(story.bodies, 1.5)->T_map_body.has_value()) << "it is gone";
  EXPECT_FALSE(latest(story.objects, 1.0)->front().found);
  EXPECT_TRUE(latest(story.objects, 1.5)->front().found);
  ASSERT_EQ(story.notes.size(), 2U);
  EXPECT_EQ(story.notes[0].value.text, "picture segmented: 2 segments");
  EXPECT_EQ(story.notes[1].value.text, "found mug");
}

TEST_F(StoryOf, PosesLieBetweenThoseThatWereTold) {
  const Story story = told(2.0);
  EXPECT_NEAR(pose_at(story, 1.1).believed.x_m, 0.55, 1e-9);  // 0.5 at 1.0 s, 0.6 at 1.2 s
  EXPECT_DOUBLE_EQ(pose_at(story, 99.0).believed.x_m, 1.0);
  EXPECT_EQ(latest(story.paths, 1.0), nullptr);
}

TEST_F(StoryOf, RefusesWhatIsNoRun) {
  run.record(folder.path(), history, 1.0);
  auto lines = history.lines();
  lines[1] = R"({"e":"objects","t":0.0})";
  EXPECT_THROW(
      {
        try {
          (void)read_story(lines);
        } catch (const InputError& e) {
          EXPECT_NE(std::string(e.what()).find("timeline.jsonl:2"), std::string::npos) << e.what();
          throw;
        }
      },
      InputError);
  EXPECT_THROW((void)read_story({R"({"e":"start","t":0,"schema":1})"}), InputError) << "no place";
  EXPECT_THROW((void)read_story({}), InputError);
}

}  // namespace
}  // namespace amiss::page
