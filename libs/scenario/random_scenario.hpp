// Scenarios by chance: what stands ready in a world, a random stream -> a Scenario whose expectations are what must
// hold whatever happens. The distribution (share/scenarios/README.md tells it, too):
//   1 to 3 of the objects from the beginning; no disturbance (3 of 10), one (5) or two (2), the first after 2 to 10 s,
//   the second 0.5 to 10 s later: a fault of a sensor (6 of 10), a kidnapping, a jump of odometry, something with an
//   object (it appears, is dropped, moved or taken away), or with the room (a door is closed, a chair moved, somebody
//   walks, something stands in the way) (1 each). Faults: sensor and kind alike, for good (1 of 2) or for 1 to 10 s;
//   lengths 0.7 to 1.4 times, periods 0.3 to 2 s, delays of 0.1 to 1 s. Nothing is put where the robot may stand, so
//   that each collision is the robot's own doing: what comes or moves is the first disturbance alone, after 2 to 4 s
//   and 2 m from the start. Where that cannot be, an object is taken away; where none is left, a sensor fails.
// Expected: no collision, an end before the time limit, and an honest one: lost or sensor_lost only where a sensor
// fails or the robot is carried, gave_up only where the room changed, never explored where camera or laser are off,
// stuck or garbage for good from the first disturbance on (10 s at the latest); where nothing misleads it and the room
// is as it was, all that is there from beginning to end is found.
#pragma once

#include "core/random.hpp"
#include "scenario/scenario.hpp"

namespace amiss::scenario {

/// What a random scenario may use.
struct Stage {
  std::string world;
  std::vector<world::AddBody> objects;      // at places that the robot can come near; at least kMostObjects
  std::vector<Eigen::Vector2d> standing_m;  // where the robot may be put down, apart from the objects; at least one
  Eigen::Vector2d start_m = Eigen::Vector2d::Zero();
  std::vector<world::CloseDoor> doors;  // that may be closed while the robot is at the start
  std::vector<std::string> chairs;      // bodies of the world, apart from the start
};
inline constexpr std::size_t kMostObjects = 4;
inline constexpr const char* kObstacle = "basket_laundry";  // what stands in the way

[[nodiscard]] Scenario random_scenario(const Stage& stage, std::uint64_t seed, int number);

}  // namespace amiss::scenario
