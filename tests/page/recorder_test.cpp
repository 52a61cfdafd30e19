#include "page/recorder.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "page/small_run.hpp"

namespace amiss::page {
namespace {

using nlohmann::json;

std::vector<json> parsed(const std::vector<std::string>& lines) {
  std::vector<json> events;
  for (const std::string& line : lines) events.push_back(json::parse(line));
  return events;
}

std::vector<json> of_kind(const std::vector<json>& events, const std::string& kind) {
  std::vector<json> chosen;
  for (const json& event : events) {
    if (event["e"] == kind) chosen.push_back(event);
  }
  return chosen;
}

struct RecorderOf : testing::Test {
  test::TemporaryFolder folder;
  History history;
  test::SmallRun run;
  std::vector<json> record(double seconds_s) {
    run.record(folder.path(), history, seconds_s);
    return parsed(history.lines());
  }
};

TEST_F(RecorderOf, BeginsWithThePlaceAndEndsWithTheReport) {
  const auto events = record(1.0);
  EXPECT_EQ(events.front()["e"], "start");
  EXPECT_EQ(events.front()["schema"], kSchema);
  EXPECT_EQ(events.front()["world"], "lab");
  EXPECT_EQ(events.front()["reference"], voxels_text(std::vector<mapping::Voxel>{{1, 2, 3}})) << "without the floor";
  EXPECT_EQ(events.back()["e"], "end");
  EXPECT_EQ(events.back()["report"]["outcome"], "explored");
  EXPECT_EQ(run.steps_before, 50) << "sinks that were there are called, too";
}

TEST_F(RecorderOf, TakesPosesAndPicturesAtFixedTimes) {
  const auto events = record(4.0);
  const auto poses = of_kind(events, "pose"), frames = of_kind(events, "frame");
  EXPECT_EQ(poses.size(), 21U);
  EXPECT_DOUBLE_EQ(poses[5]["t"], 1.0);
  EXPECT_EQ(poses[5]["head"], json({0.2, -0.4}));
  EXPECT_EQ(poses[5]["true"], json({0.5, 0.25, 0.0}));
  ASSERT_EQ(frames.size(), 5U);
  std::size_t next = 0;
  for (const json& frame : frames) {
    for (const char* picture : {"colour", "depth"}) {
      EXPECT_EQ(frame[picture][0], next) << "one after the other";
      next += frame[picture][1].get<std::size_t>();
    }
  }
  const std::string camera = folder.read(Recorder::kCamera);
  EXPECT_EQ(camera.size(), next);
  EXPECT_EQ(camera.substr(0, 2), "\xff\xd8") << "a JPEG";
}

TEST_F(RecorderOf, TellsEachVoxelWhenItChanges) {
  const mapping::Voxel a{3, 0, 2}, b{20, -5, 9}, floor{3, 0, -1};
  run.during = [&](mission::Sinks&, int i) {
    if (i == 10) run.current.set(a, Occupancy::kOccupied);
    if (i == 10) run.current.set(floor, Occupancy::kOccupied);
    if (i == 70) run.current.set(b, Occupancy::kOccupied);
    if (i == 70) run.current.set(a, Occupancy::kFree);
  };
  const auto voxels = of_kind(record(3.0), "voxels");
  ASSERT_EQ(voxels.size(), 2U);
  EXPECT_EQ(voxels[0]["on"], voxels_text(std::vector{a}));
  EXPECT_EQ(voxels[0]["off"], "");
  EXPECT_EQ(voxels[1]["on"], voxels_text(std::vector{b}));
  EXPECT_EQ(voxels[1]["off"], voxels_text(std::vector{a}));
  EXPECT_DOUBLE_EQ(voxels[1]["t"], 2.0);
}

TEST_F(RecorderOf, TellsKnowledgeAndVerdictsOnceForEachChange) {
  const knowledge::Sighting sighting{{1.0, 2.0, 0.1}, {{1.0, 2.0}, 0.1, 0.0, 0.2}, 5};
  const std::vector<segment::Segment> segments(2);
  run.during = [&](mission::Sinks& sinks, int i) {
    const mission::ProgressEvent progress{run.now, 3.0, 1, 0};
    if (i == 20)
      run.knowledge.merge(
          {sighting}, [](const knowledge::Region&) { return true; }, run.now);
    if (i == 20 || i == 21 || i == 22) sinks.progress(progress);
    if (i != 60) return;
    run.knowledge.mark_examined(1, run.now);
    run.objects[0].found = true;
    run.touches.push_back({run.now, "hand", "vase", {{1.0, 2.0, 0.5}}});
    sinks.examined({1, run.now, &run.frame, {}, &segments, 0.0, {}});
  };
  const auto events = record(2.0);
  const auto regions = of_kind(events, "regions"), objects = of_kind(events, "objects");
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0]["list"][0]["state"], "open");
  EXPECT_EQ(regions[1]["list"][0]["state"], "examined");
  EXPECT_EQ(regions[1]["list"][0]["examined_at"], 1.2);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[1]["list"][0]["found"], true);
  const auto examined = of_kind(events, "examined"), collisions = of_kind(events, "collision");
  ASSERT_EQ(examined.size(), 1U);
  EXPECT_EQ(examined[0]["segments"].size(), 2U);
  ASSERT_EQ(collisions.size(), 1U);
  EXPECT_EQ(collisions[0]["body"], "vase");
  EXPECT_EQ(of_kind(events, "progress").size(), 1U) << "no more than one a second";
}

TEST_F(RecorderOf, TellsOfBodiesWhenTheyMoveOrGo) {
  run.place.T_world_map.T.translate(Eigen::Vector3d(6.0, 5.0, 0.01));
  run.bodies.push_back({"mug", "mug", {}});
  run.bodies.push_back({"ball", "", {}});
  run.during = [&](mission::Sinks&, int i) {
    if (i > 20 && i <= 50) run.bodies[0].T_map_body.T.pretranslate(Eigen::Vector3d(0.0, 1e-4, 0.0));
    if (i == 80) run.bodies.pop_back();
  };
  const auto events = record(2.0);
  EXPECT_EQ(events.front()["place"],
            json({{"world", "lab"}, {"robot", ""}, {"T_world_map", {6.0, 5.0, 0.01, 0.0, 0.0, 0.0, 1.0}}}));
  const auto bodies = of_kind(events, "bodies");
  ASSERT_EQ(bodies.size(), 3U) << "all at first, 2 mm at least, one that is gone";
  EXPECT_EQ(bodies[0]["list"].size(), 2U);
  EXPECT_EQ(bodies[1]["list"][0]["name"], "mug");
  EXPECT_GE(bodies[1]["list"][0]["pose"][1], 0.002);
  EXPECT_EQ(bodies[2]["gone"], json({"ball"}));
}

TEST_F(RecorderOf, TellsWhatAScriptDidAndWhatItPutThere) {
  run.during = [&](mission::Sinks&, int i) {
    if (i != 60 && i != 100) return;
    run.script.push_back({run.now, "add mug"});
    run.objects.push_back({"mug_" + std::to_string(i), "mug", {{1.0, 2.0, 0.05}}, false, false, 0.0, 0.0, 0.0, 0.0});
  };
  const auto events = record(2.0);
  const auto script = of_kind(events, "script"), objects = of_kind(events, "objects");
  ASSERT_EQ(script.size(), 2U);
  EXPECT_EQ(script[0]["t"], 1.2);
  EXPECT_EQ(script[0]["text"], "add mug");
  EXPECT_EQ(script[1]["t"], 2.0) << "the last one, too";
  ASSERT_EQ(objects.size(), 3U);
  EXPECT_EQ(objects[1]["list"].size(), 2U);
}

TEST_F(RecorderOf, WritesTheSameWithAndWithoutAThread) {
  test::TemporaryFolder other;
  History second;
  run.record(folder.path(), history, 5.0, false);
  run.record(other.path(), second, 5.0, true);
  for (const char* file : {Recorder::kTimeline, Recorder::kCamera}) {
    EXPECT_EQ(folder.read(file), other.read(file)) << file;
    EXPECT_FALSE(folder.read(file).empty());
  }
  std::string lines;
  for (const std::string& line : history.lines()) lines += line + "\n";
  EXPECT_EQ(folder.read(Recorder::kTimeline), lines) << "pages and files are told the same";
}

TEST(Recorder, SaysWhenItCannotWrite) {
  History history;
  EXPECT_THROW(Recorder("/proc/amiss", history, false), std::runtime_error);
  test::TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / Recorder::kTimeline);
  test::SmallRun run;
  EXPECT_THROW(run.record(folder.path(), history, 30.0), std::runtime_error);
}

}  // namespace
}  // namespace amiss::page
