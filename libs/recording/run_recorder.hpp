// Records a run as MCAP while it goes on: what the robot's sensors said, exactly, and what the stages made of it, as
// ROS 2 messages. Half a simulated second becomes a chunk and is in the file before the next one ends: a run that is
// killed loses a second at most. Pictures and chunks are compressed beside the run. Recording changes nothing in a run.
//
//   RunRecorder recorder(file, setup, threaded);
//   RecordingRobot robot(simulator, [&](const auto& o) { recorder.record(o); });  // what the mission gets
//   recorder.attach(sinks, knowledge);
//   ... the run ...
//   recorder.close();
// std::runtime_error where the file cannot be written. Topics: README.md
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "knowledge/knowledge_base.hpp"
#include "mapping/voxel_map.hpp"
#include "mission/sinks.hpp"
#include "recording/batches.hpp"
#include "recording/mcap_writer.hpp"
#include "recording/run_setup.hpp"
#include "robot/robot.hpp"

namespace amiss::recording {

class RunRecorder {
 public:
  RunRecorder(const std::filesystem::path& file, const RunSetup& setup, bool threaded);
  ~RunRecorder();
  RunRecorder(const RunRecorder&) = delete;
  RunRecorder& operator=(const RunRecorder&) = delete;

  void record(const robot::Observation& observation);
  /// Listens to these sinks too; what was attached before is called first. The recorder outlives the sinks, and the
  /// knowledge and the map that it is shown.
  void attach(mission::Sinks& sinks, const knowledge::KnowledgeBase& knowledge,
              std::function<const mapping::VoxelMap&()> voxels);
  /// A line of the run's log.
  void log(Stamp stamp, const std::string& text);
  void close();

 private:
  struct Pending {
    ChannelId channel = 0;
    Stamp stamp;
    std::function<std::string()> message;  // made where it is written
  };
  ChannelId channel(const std::string& topic, const std::string& type);
  void put(const char* topic, const char* type, Stamp stamp, std::string message);
  void put_later(const char* topic, const char* type, Stamp stamp, std::function<std::string()> message);
  void record_frame(const RgbdFrame& frame);
  void on_step(const mission::StepEvent& event);
  void write_knowledge();
  void write_map();
  void write(const std::vector<Pending>& batch);

  McapWriter writer_;
  const robot::Model& model_;
  double floor_clearance_m_;
  std::map<std::string, ChannelId, std::less<>> channels_;
  const knowledge::KnowledgeBase* knowledge_ = nullptr;
  std::function<const mapping::VoxelMap&()> voxels_;
  Pose2<Odom, Base> T_odom_base_;
  Stamp now_, next_flush_, next_map_;
  std::string told_markers_;
  std::uint64_t told_revision_ = 0;
  Batches<Pending> batches_;  // the last member, so that it ends before what it works on
};

/// A robot that somebody listens to.
class RecordingRobot final : public robot::Robot {
 public:
  using Listener = std::function<void(const robot::Observation&)>;
  RecordingRobot(robot::Robot& robot, Listener listener) : robot_(robot), listener_(std::move(listener)) {}
  [[nodiscard]] const robot::Model& model() const override { return robot_.model(); }
  void command(const robot::Command& command) override { robot_.command(command); }
  robot::Observation observe() override {
    robot::Observation observation = robot_.observe();
    listener_(observation);
    return observation;
  }

 private:
  robot::Robot& robot_;
  Listener listener_;
};

}  // namespace amiss::recording
