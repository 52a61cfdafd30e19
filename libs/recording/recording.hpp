// A recorded run from front to back: what the robot's sensors said, and where the mission compared and segmented.
//
// in: MCAP file that a RunRecorder wrote, whole or broken off     out: entries in the order in which they happened
// InputError names the file and what is wrong: no recording of amiss, a message that is cut short, a frame whose images
// are missing.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "recording/mcap_reader.hpp"
#include "recording/robot_messages.hpp"

namespace amiss::recording {

/// A segmentation begins; these are the colours of the frame that it looks at, as they were.
struct Segmenting {
  std::string colour_message;
};
using Entry = std::variant<robot::Observation, Decision, Segmenting>;

class Recording {
 public:
  /// Reads up to the setup.
  explicit Recording(const std::filesystem::path& file);

  [[nodiscard]] const Setup& setup() const { return setup_; }
  /// By name: parameters, the world, the files of the reference.
  [[nodiscard]] const std::map<std::string, std::string>& documents() const { return reader_.attachments(); }
  std::optional<Entry> next();
  /// At the end: false for a run that was killed.
  [[nodiscard]] bool complete() const { return reader_.complete(); }

 private:
  [[nodiscard]] robot::Observation observation_of(std::string_view message);

  std::filesystem::path path_;
  McapReader reader_;
  Setup setup_;
  CameraIntrinsics camera_;
  std::optional<LaserScan> scan_;   // the ranges alone
  std::optional<RgbdFrame> frame_;  // the depth alone
  std::string segmented_;
};

}  // namespace amiss::recording
