// What a replay reads: what the robot's sensors said, in the order in which it arrived, and where the mission compared
// and segmented. One for each format of recordings.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "dataset/robot_bag.hpp"
#include "recording/robot_messages.hpp"

namespace amiss::recording {

/// A segmentation begins; these are the colours of the frame that it looks at, as they were.
struct Segmenting {
  std::string colour_message;
};
using Entry = std::variant<robot::Observation, Decision, Segmenting>;

class Source {
 public:
  Source() = default;
  virtual ~Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  [[nodiscard]] virtual const Setup& setup() const = 0;
  /// By name: parameters, the world, the files of the reference.
  [[nodiscard]] virtual const std::map<std::string, std::string>& documents() const = 0;
  virtual std::optional<Entry> next() = 0;
  /// At the end: false for a run that was killed.
  [[nodiscard]] virtual bool complete() const = 0;
  /// Scans and frames that cannot be placed in time or on the robot.
  [[nodiscard]] virtual std::size_t dropped() const { return 0; }
  /// False: no mission compared or segmented in it.
  [[nodiscard]] virtual bool tells_decisions() const { return true; }
};

/// What a bag does not say.
struct BagSetting {
  dataset::RobotBagOptions bag;
  Pose2<Map, Base> T_map_base;  // where the robot begins
};
/// The recording that the first bytes of the file tell: MCAP, rawlog or ROS 1 bag. InputError for any other.
[[nodiscard]] std::unique_ptr<Source> open_source(const std::filesystem::path& file, const BagSetting& setting = {});

}  // namespace amiss::recording
