// What the robot's sensors said, exactly: amiss_msgs/Observation and the sensor messages in front of it <->
// Observation.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "robot/robot.hpp"

namespace amiss::recording {

struct Setup {
  std::uint64_t seed = 0;
  std::string method;
  Transform<Base, Laser> T_base_laser;
  Pose2<Map, Base> T_map_base = {};  // where the robot begins; a mission's robot begins at the map's origin
};
/// All but where the robot begins.
[[nodiscard]] std::string setup_message(const Setup& setup);
[[nodiscard]] Setup parse_setup(std::string_view message);

/// All but the ranges of the scan and the pixels of the frame, which have messages of their own.
[[nodiscard]] std::string observation_message(const robot::Observation& observation);
[[nodiscard]] robot::Observation parse_observation(std::string_view message);
/// Into the parts of an observation whose own messages these are.
void parse_ranges(std::string_view scan_message, LaserScan& scan);
void parse_depth(std::string_view image_message, RgbdFrame& frame);
void parse_colour(std::string_view image_message, RgbdFrame& frame);
void parse_camera_info(std::string_view message, CameraIntrinsics& camera);

/// What the mission did at this place of the recording, so that a replay does it there too.
struct Decision {
  enum class Kind : std::uint8_t { kCompared = 0, kSegmenting = 1, kExamined = 2 };
  Kind kind = Kind::kCompared;
  int region = 0;  // of kExamined
};
[[nodiscard]] std::string decision_message(const Decision& decision);
[[nodiscard]] Decision parse_decision(std::string_view message);

}  // namespace amiss::recording
