// What happens to a world and to the robot's sensors while the robot works: events, each with the moment it waits for.
// Values only; sim carries them out (sim/scripted_robot.hpp). Lengths in m, angles in rad, times in s of simulated
// time, all places in the world frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/frames.hpp"

namespace amiss::world {

/// Where a body is put. Without z it stands on the floor.
struct Place {
  double x_m = 0.0, y_m = 0.0;
  std::optional<double> z_m;
  double yaw_rad = 0.0;
};

/// A body that was not there: an object of the catalogue, or a piece of furniture. From a z above the floor it falls.
struct AddBody {
  std::string kind, name;
  Place place;
};
struct MoveBody {
  std::string name;
  Place place;
};
struct RemoveBody {
  std::string name;
};
/// The leaf is put into its frame.
struct CloseDoor {
  std::string leaf, frame;
};
/// Somebody walks along the places and is gone at the last one; waits for the robot where it is in the way.
struct Walk {
  std::string name;
  std::vector<Eigen::Vector2d> way_m;
  double speed_m_s = 0.8;
};
/// The robot is picked up and put down elsewhere; its odometry knows nothing of it.
struct Kidnap {
  Pose2<amiss::World, Base> T_world_base;
};

enum class Sensor { kCamera, kLaser, kOdometry };
enum class FaultKind { kOff, kStuck, kGarbage, kWrong, kSlow, kDelayed, kIntermittent, kJump };
[[nodiscard]] std::string_view to_string(Sensor sensor);
[[nodiscard]] std::string_view to_string(FaultKind kind);

/// What `amount` means depends on the kind: kWrong the factor by which lengths are too long, kSlow the period [s],
/// kDelayed how much later a measurement arrives [s], kIntermittent how long it is there and how long it is not [s].
struct Fault {
  Sensor sensor = Sensor::kCamera;
  FaultKind kind = FaultKind::kOff;
  double for_s = 1e9;
  double amount = 0.0;
  Pose2<Base, Base> jump;  // kJump, odometry only: motion that there was not
};

using Change = std::variant<AddBody, MoveBody, RemoveBody, CloseDoor, Walk, Kidnap, Fault>;

/// What an event waits for. Detected: the robot has a region where the object is; examined: it has segmented it.
struct Moment {
  enum class Kind { kTime, kRobotNear, kDetected, kExamined };
  Kind kind = Kind::kTime;
  double after_s = 0.0;  // kTime: since the beginning, else: since the moment
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
  double within_m = 0.0;
  std::string object;
};

struct Event {
  Moment moment;
  Change change;
};

struct Script {
  std::vector<Event> events;
};

/// "mug appears at (1.20, 3.00)": for logs and reports.
[[nodiscard]] std::string to_string(const Change& change);

}  // namespace amiss::world
