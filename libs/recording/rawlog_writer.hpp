// Writes what the robot's sensors said as an MRPT rawlog (a list of observations, gzipped): rawlog-edit, RawLogViewer
// and MRPT's SLAM programs read it. Odometry, laser scans, RGB-D frames with depth rounded to 1 mm, all with their
// poses on the robot. Frames are compressed beside the run. in: observations     out: the file; std::runtime_error
// where it cannot be written. close() makes it whole.
// With a setup it also holds what a replay needs, as CObservationRawDAQ named by topics: setup, documents, what
// rounding took away from depth, the observation's exact numbers, the mission's decisions.
#pragma once

#include <filesystem>
#include <memory>

#include "mission/sinks.hpp"
#include "recording/run_setup.hpp"
#include "robot/robot.hpp"

namespace amiss::recording {

class RawlogWriter {
 public:
  RawlogWriter(const std::filesystem::path& file, const Transform<Base, Laser>& T_base_laser, bool threaded);
  /// For a replay.
  RawlogWriter(const std::filesystem::path& file, const RunSetup& setup, bool threaded);
  ~RawlogWriter();
  RawlogWriter(const RawlogWriter&) = delete;
  RawlogWriter& operator=(const RawlogWriter&) = delete;

  void record(const robot::Observation& observation);
  /// Listens to the decisions of a mission; what was attached before is called first. Outlives the sinks.
  void attach(mission::Sinks& sinks);
  void close();

  static constexpr const char *kSetup = "/amiss/setup", *kDocuments = "/amiss/documents/", *kDepth = "/amiss/depth",
                              *kObservation = "/amiss/observation", *kDecisions = "/amiss/decisions",
                              *kSegmented = "/amiss/segmented";

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace amiss::recording
