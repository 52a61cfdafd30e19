// `--record` of a tidy-up run: recording.mcap and recording.rawlog in the run folder, each with all that a
// replay needs.
#pragma once

#include <memory>
#include <string>

#include "mission/reference.hpp"
#include "recording/rawlog_writer.hpp"
#include "recording/run_recorder.hpp"
#include "report/run_folder.hpp"
#include "world/world.hpp"

namespace amiss::app {

class TidyRecording {
 public:
  struct Wanted {
    std::string format;  // mcap, rawlog, both, or nothing
    std::uint64_t seed = 0;
    std::string method;
    double floor_clearance_m = 0.0;
    const mission::Reference& reference;
    const world::World& world;
    bool threaded = true;
  };
  TidyRecording(robot::Robot& robot, const report::RunFolder& folder, const Wanted& wanted);
  TidyRecording(const TidyRecording&) = delete;
  TidyRecording& operator=(const TidyRecording&) = delete;

  /// The robot that the mission is to command.
  [[nodiscard]] robot::Robot& robot() { return mcap_ || rawlog_ ? recording_robot_ : robot_; }
  void attach(mission::Sinks& sinks, const knowledge::KnowledgeBase& knowledge,
              std::function<const mapping::VoxelMap&()> voxels);
  void log(Stamp stamp, const std::string& text);
  void close();

  static constexpr const char *kMcap = "recording.mcap", *kRawlog = "recording.rawlog";

 private:
  void record(const robot::Observation& observation);

  robot::Robot& robot_;
  recording::RecordingRobot recording_robot_;
  std::unique_ptr<recording::RunRecorder> mcap_;
  std::unique_ptr<recording::RawlogWriter> rawlog_;
};

}  // namespace amiss::app
