// A small made-up run: what was told stands in the file; what was recorded is what the robot said.
#include "recording/run_recorder.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/temporary_folder.hpp"
#include "recording/recording.hpp"

namespace amiss::recording {
namespace {

using namespace std::chrono_literals;

/// Says one thing after the other: a scan each period of 0.1 s, a frame every second one.
class TalkingRobot final : public robot::Robot {
 public:
  [[nodiscard]] const robot::Model& model() const override { return model_; }
  void command(const robot::Command&) override {}
  robot::Observation observe() override {
    robot::Observation o;
    o.stamp = Stamp{100ms * ++period_};
    o.odometry = {o.stamp, {0.01 * period_, 0.1, 0.2}};
    o.scan = LaserScan{o.stamp, -1.0, 0.5, 0.05, 30.0, {1.0F, 2.0F, static_cast<float>(period_)}};
    if (period_ % 2 == 0) {
      auto& [frame, T_base_camera, T_odom_base] = o.frame.emplace();
      frame = {o.stamp,
               {8, 4, 5.0, 5.0, 3.5, 1.5},
               std::vector<Rgb>(32, Rgb{9, 8, 7}),
               std::vector<float>(32, static_cast<float>(period_))};
      T_base_camera.T.translation().z() = 1.0;
      T_odom_base = o.odometry.T_odom_base;
    }
    return o;
  }

  void begin_again() { period_ = 0; }

 private:
  robot::Model model_ = robot::load_model(AMISS_SOURCE_DIR "/robot_model/hsr.urdf");
  int period_ = 0;
};

struct RunRecorderTest : testing::Test {
  test::TemporaryFolder folder;
  TalkingRobot talking;
  knowledge::KnowledgeBase knowledge{knowledge::Params{}};
  mapping::VoxelMap voxels;
  FloorGrid floor{0.05, {0, 0}, 4, 4};
  mission::Sinks sinks;

  std::unique_ptr<RunRecorder> recorder(const std::string& name, bool threaded) {
    RunSetup setup{5, "dynamic", 0.012, &talking.model(), &floor, {{"params.yaml", "a: 1\n"}}};
    auto made = std::make_unique<RunRecorder>(folder.path() / name, setup, threaded);
    sinks = {};
    made->attach(sinks, knowledge, [this]() -> const mapping::VoxelMap& { return voxels; });
    return made;
  }
  void run(RunRecorder& recorder, int periods) {
    RecordingRobot robot(talking, [&](const robot::Observation& o) { recorder.record(o); });
    for (int i = 0; i < periods; ++i) {
      const robot::Observation o = robot.observe();
      sinks.step({{o.stamp, {}, {}, true}, false, {}});
      if (i % 5 == 4) sinks.compared({o.stamp, 0.0, &difference});
      recorder.log(o.stamp, "period " + std::to_string(i));
    }
  }
  change::Difference difference;
};

TEST_F(RunRecorderTest, TheRobotIsReadBack) {
  const auto made = recorder("a.mcap", true);
  run(*made, 25);
  made->close();
  Recording recording(folder.path() / "a.mcap");
  EXPECT_EQ(recording.setup().seed, 5U);
  EXPECT_EQ(recording.documents().at("params.yaml"), "a: 1\n");
  TalkingRobot again;
  int observations = 0, comparisons = 0;
  while (const auto entry = recording.next()) {
    if (std::holds_alternative<Decision>(*entry)) ++comparisons;
    const auto* o = std::get_if<robot::Observation>(&*entry);
    if (o == nullptr) continue;
    const robot::Observation said = again.observe();
    ++observations;
    EXPECT_EQ(o->stamp, said.stamp);
    EXPECT_EQ(o->scan->ranges_m, said.scan->ranges_m);
    ASSERT_EQ(o->frame.has_value(), said.frame.has_value());
    if (!said.frame) continue;
    EXPECT_EQ(o->frame->frame.depth_m, said.frame->frame.depth_m);
    EXPECT_EQ(o->frame->frame.intrinsics, said.frame->frame.intrinsics);
    EXPECT_EQ(o->frame->frame.stamp, said.frame->frame.stamp);
  }
  EXPECT_EQ(observations, 25);
  EXPECT_EQ(comparisons, 5);
  EXPECT_TRUE(recording.complete());
}

TEST_F(RunRecorderTest, AllTopicsAreThereAndThreadsChangeNothing) {
  for (const bool threaded : {false, true}) {
    talking.begin_again();
    const auto made = recorder(threaded ? "b.mcap" : "a.mcap", threaded);
    run(*made, 25);
    made->close();
  }
  EXPECT_TRUE(folder.read("a.mcap") == folder.read("b.mcap"));
  McapReader reader(folder.path() / "a.mcap");
  std::set<std::string> topics;
  while (const auto message = reader.next()) topics.insert(message->channel->topic);
  for (const char* topic : {"/tf", "/tf_static", "/map", "/scan", "/odom", "/camera/camera_info", "/difference",
                            "/camera/depth/image_raw", "/camera/rgb/image_raw/compressed", "/rosout"}) {
    EXPECT_TRUE(topics.contains(topic)) << topic;
  }
}

TEST_F(RunRecorderTest, WithoutAnEndHalfASecondIsMissingAtMost) {
  const auto made = recorder("a.mcap", false);
  run(*made, 25);  // 2.5 s; never closed
  Recording recording(folder.path() / "a.mcap");
  Stamp last;
  while (const auto entry = recording.next()) {
    if (const auto* o = std::get_if<robot::Observation>(&*entry)) last = o->stamp;
  }
  EXPECT_FALSE(recording.complete());
  EXPECT_GE(last, Stamp{2000ms});
}

TEST_F(RunRecorderTest, WhenWrittenBesideTheRunASecondIsMissingAtMost) {
  const auto made = recorder("a.mcap", true);
  run(*made, 30);  // 3 s: the last half second has just begun to be written, all before is
  Recording recording(folder.path() / "a.mcap");
  Stamp last;
  while (const auto entry = recording.next()) {
    if (const auto* o = std::get_if<robot::Observation>(&*entry)) last = o->stamp;
  }
  EXPECT_GE(last, Stamp{2000ms});
}

TEST_F(RunRecorderTest, AFullDiskIsToldInOneSentence) {
  std::filesystem::create_symlink("/dev/full", folder.path() / "a.mcap");
  EXPECT_EQ(test::sentence_of<std::runtime_error>([&] {
              const auto made = recorder("a.mcap", true);
              run(*made, 25);
              made->close();
            }),
            (folder.path() / "a.mcap").string() + ": cannot be written");
}

}  // namespace
}  // namespace amiss::recording
