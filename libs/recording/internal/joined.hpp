// An observation as it was: its message joined with the ranges and the depth that stand in messages of their own in
// front of it. InputError where one of them is missing.
#pragma once

#include <optional>
#include <string_view>

#include "core/result.hpp"
#include "recording/robot_messages.hpp"

namespace amiss::recording::internal {

/// Both are taken: the next observation has others.
inline robot::Observation joined(std::string_view message, std::optional<LaserScan>& scan,
                                 std::optional<RgbdFrame>& frame) {
  robot::Observation observation = parse_observation(message);
  if (observation.scan) {
    if (!scan) throw InputError("the scan of an observation is missing");
    observation.scan->ranges_m = std::move(scan->ranges_m);
  }
  if (observation.frame) {
    if (!frame) throw InputError("the frame of an observation is missing");
    frame->stamp = observation.frame->frame.stamp;
    observation.frame->frame = std::move(*frame);
  }
  scan.reset();
  frame.reset();
  return observation;
}

}  // namespace amiss::recording::internal
