// Drives from one waypoint to the next and looks round at each: how a place is recorded (thesis 3.2).
// Robot, reference map, waypoints in the map frame -> what was reached; frames, steps and log go to the sinks. A
// waypoint that cannot be reached is left out and told of.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mission/params.hpp"
#include "mission/reference.hpp"

namespace amiss::mission {

struct TourParams {
  double tolerance_m = 0.5;        // a waypoint may be moved by this to where the robot can stand: things may lie on it
  double pan_rad = radians(50.0);  // of the head to both sides
  double low_tilt_rad = -radians(48.0);  // a sweep to the left low, back over the right and over the left high
  double high_tilt_rad = -radians(22.0);
  double head_rate_rad_s = 0.5;  // slower than the head can, so that frames overlap
};
void describe(ParamTable& table, TourParams& params);

struct TourReport {
  std::size_t reached = 0;
  std::vector<std::string> left_out;  // "waypoint 3: why"
  bool complete = false;              // went to its end, whatever was reached
  double distance_m = 0.0;
  Stamp ended;
};

/// `start`: where the robot stands, within a few centimetres and degrees.
[[nodiscard]] TourReport drive_tour(robot::Robot& robot, const Reference& reference, const Pose2<Map, Base>& start,
                                    std::span<const Pose2<Map, Base>> waypoints, const Params& params,
                                    const TourParams& tour, std::uint64_t seed, const Sinks& sinks);

}  // namespace amiss::mission
