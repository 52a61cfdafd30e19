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
    if (i == 80) run.script.push_back({run.now, "mug is taken away"});
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
  ASSERT_EQ(story.notes.size(), 3U);
  EXPECT_EQ(story.notes[0].value.text, "picture segmented: 2 segments");
  EXPECT_EQ(story.notes[1].value.text, "found mug");
  EXPECT_EQ(story.notes[2].value.kind, Note::Kind::kScript);
  EXPECT_EQ(story.notes[2].value.text, "mug is taken away");
}

TEST_F(StoryOf, KeepsWhatTheMapHeldAndWhatWasDecided) {
  run.current.set({3, 4, 5}, Occupancy::kOccupied);
  run.current.set({-3, -4, 0}, Occupancy::kOccupied);
  const knowledge::Sighting seen{{1.0, 2.0, 0.1}, {{1.0, 2.0}, 0.25, 0.05, 0.3}, 9};
  run.during = [&](mission::Sinks& sinks, int i) {
    if (i == 60) run.current.set({3, 4, 5}, Occupancy::kFree);
    if (i == 60) run.knowledge.merge({seen}, {}, run.now);
    if (i == 60) run.knowledge.add_views({{0, {0.5, 0.5, 1.0}, 1.0, 2.0, false, std::nullopt}});
    const change::Difference difference{{{7, 8, 1}}, {{1, 2, 3}}, 0};
    if (i == 60) sinks.compared({run.now, 0.0, &difference});
    std::vector<segment::Segment> segments(1);
    segments[0].size_m = {0.1, 0.2, 0.3};
    if (i == 60) sinks.examined({1, run.now, &run.frame, {}, &segments, 0.0, {}});
  };
  const Story story = told(2.2);
  EXPECT_EQ(story.reference, (std::vector<mapping::Voxel>{{1, 2, 3}})) << "the floor is left out";
  EXPECT_DOUBLE_EQ(story.resolution_m, run.reference.resolution_m());
  EXPECT_EQ(voxels_at(story, 0.9), (std::vector<mapping::Voxel>{{-3, -4, 0}, {3, 4, 5}}));
  EXPECT_EQ(voxels_at(story, 2.2), (std::vector<mapping::Voxel>{{-3, -4, 0}}));
  ASSERT_EQ(story.differences.size(), 1U);
  EXPECT_EQ(story.differences[0].value.appeared, (std::vector<mapping::Voxel>{{7, 8, 1}}));
  EXPECT_EQ(story.differences[0].value.vanished, (std::vector<mapping::Voxel>{{1, 2, 3}}));
  ASSERT_NE(latest(story.regions, 2.2), nullptr);
  EXPECT_DOUBLE_EQ(latest(story.regions, 2.2)->front().z_high_m, 0.3);
  ASSERT_NE(latest(story.views, 2.2), nullptr);
  EXPECT_DOUBLE_EQ(latest(story.views, 2.2)->front().height_m, 2.0);
  ASSERT_EQ(story.segments.size(), 1U);
  EXPECT_EQ(story.segments[0].value[0].size_m, Eigen::Vector3d(0.1, 0.2, 0.3));
}

TEST_F(StoryOf, TurnsTheRobotsHeadAsItsModelDoes) {
  const Story story = told(1.0);
  const robot::HeadState head{0.4, -0.5};
  const auto links = run.model.link_poses({{run.model.pan_joint, head.pan_rad}, {run.model.tilt_joint, head.tilt_rad}});
  std::vector<Eigen::Vector3d> expected;
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const robot::LinkShape& shape : run.model.links[i].visuals)
      expected.emplace_back((links[i] * shape.T_link_shape).translation());
  }
  const auto shapes = shapes_at(story.robot, head);
  ASSERT_EQ(shapes.size(), expected.size());
  for (std::size_t i = 0; i < shapes.size(); ++i)
    EXPECT_LT((shapes[i].T_base_shape.translation() - expected[i]).norm(), 1e-3) << i;
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
  lines = history.lines();
  lines.insert(lines.end() - 1, R"({"e":"voxels","t":0.5,"on":"AAAA","off":""})");
  EXPECT_THROW((void)read_story(lines), InputError) << "three bytes are no voxel";
  EXPECT_THROW((void)read_story({}), InputError);
  lines = history.lines();
  const std::string origin = R"("origin":[-1.0,-1.0])";
  ASSERT_NE(lines[0].find(origin), std::string::npos);
  lines[0].replace(lines[0].find(origin), origin.size(), R"("origin":[1e300,0])");
  EXPECT_NE(test::sentence_of<InputError>([&] { (void)read_story(lines); }).find("timeline.jsonl:1: the floor is"),
            std::string::npos);
}

}  // namespace
}  // namespace amiss::page
