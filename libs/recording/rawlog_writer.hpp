// Writes what the robot's sensors said as an MRPT rawlog (a list of observations, gzipped): rawlog-edit, RawLogViewer
// and MRPT's SLAM programs read it. Odometry, laser scans, RGB-D frames with depth rounded to 1 mm, all with their
// poses on the robot. Frames are compressed beside the run. in: observations     out: the file; std::runtime_error
// where it cannot be written. close() makes it whole.
#pragma once

#include <filesystem>
#include <memory>

#include "robot/robot.hpp"

namespace amiss::recording {

class RawlogWriter {
 public:
  RawlogWriter(const std::filesystem::path& file, const Transform<Base, Laser>& T_base_laser, bool threaded);
  ~RawlogWriter();
  RawlogWriter(const RawlogWriter&) = delete;
  RawlogWriter& operator=(const RawlogWriter&) = delete;

  void record(const robot::Observation& observation);
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace amiss::recording
