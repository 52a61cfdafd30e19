// Watches a simulated robot on its tour and writes what it senses, what it believes and what is true.
#pragma once

#include <deque>
#include <memory>

#include "dataset/carmen_log.hpp"
#include "dataset/instance_images.hpp"
#include "dataset/tum_writer.hpp"
#include "mission/sinks.hpp"
#include "recording/rawlog_writer.hpp"
#include "robot/model.hpp"
#include "score/alignment.hpp"
#include "sim/simulator.hpp"

namespace amiss::app {

/// The robot as it is; what it observes is told of first.
class ObservedRobot final : public robot::Robot {
 public:
  using Sink = std::function<void(const robot::Observation&)>;
  ObservedRobot(robot::Robot& robot, Sink sink) : robot_(robot), sink_(std::move(sink)) {}
  [[nodiscard]] const robot::Model& model() const override { return robot_.model(); }
  void command(const robot::Command& command) override { robot_.command(command); }
  robot::Observation observe() override {
    robot::Observation seen = robot_.observe();
    sink_(seen);
    return seen;
  }

 private:
  robot::Robot& robot_;
  Sink sink_;
};

class DatasetRecorder {
 public:
  /// `floor_clearance_m`: by how much the robot's map lies above the floor; z = 0 of the recording is the floor.
  DatasetRecorder(const std::filesystem::path& folder, const sim::Simulator& simulator,
                  const Pose2<World, Map>& T_world_map, double floor_clearance_m);

  /// recording.rawlog beside the images, from now on.
  void also_as_rawlog();

  void observed(const robot::Observation& seen);
  void believed(const mission::StepEvent& step);
  void framed(const mission::FrameEvent& event);
  void finish();

  [[nodiscard]] std::size_t frames() const { return frames_; }
  [[nodiscard]] const std::vector<score::PosePair>& poses() const { return poses_; }

 private:
  struct Moment {
    Stamp stamp;
    Transform<World, Camera> T_world_camera;
  };

  std::filesystem::path folder_;
  const sim::Simulator& simulator_;
  Pose2<World, Map> T_world_map_;
  double floor_clearance_m_;
  dataset::TumWriter writer_;
  dataset::InstanceWriter instances_;
  dataset::CarmenLog log_;
  std::unique_ptr<recording::RawlogWriter> rawlog_;
  std::deque<Moment> moments_;  // the latest ones
  std::size_t frames_ = 0;
  std::vector<score::PosePair> poses_;
};

}  // namespace amiss::app
