#include "world/script.hpp"

#include <cstdio>

namespace amiss::world {

namespace {

std::string at(double x_m, double y_m) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.2f, %.2f)", x_m, y_m);
  return text;
}

struct Teller {
  std::string operator()(const AddBody& c) const { return c.name + " appears at " + at(c.place.x_m, c.place.y_m); }
  std::string operator()(const MoveBody& c) const { return c.name + " is moved to " + at(c.place.x_m, c.place.y_m); }
  std::string operator()(const RemoveBody& c) const { return c.name + " is taken away"; }
  std::string operator()(const CloseDoor& c) const { return c.leaf + " is closed in " + c.frame; }
  std::string operator()(const Walk& c) const {
    return c.name + " walks from " + at(c.way_m.front().x(), c.way_m.front().y()) + " to " +
           at(c.way_m.back().x(), c.way_m.back().y());
  }
  std::string operator()(const Kidnap& c) const {
    return "the robot is carried to " + at(c.T_world_base.x_m, c.T_world_base.y_m);
  }
  std::string operator()(const Fault& c) const {
    return std::string(to_string(c.sensor)) + " is " + std::string(to_string(c.kind));
  }
};

}  // namespace

std::string_view to_string(Sensor sensor) {
  switch (sensor) {
    case Sensor::kCamera:
      return "camera";
    case Sensor::kLaser:
      return "laser";
    case Sensor::kOdometry:
      return "odometry";
  }
  return "";
}

std::string_view to_string(FaultKind kind) {
  switch (kind) {
    case FaultKind::kOff:
      return "off";
    case FaultKind::kStuck:
      return "stuck";
    case FaultKind::kGarbage:
      return "garbage";
    case FaultKind::kWrong:
      return "wrong";
    case FaultKind::kSlow:
      return "slow";
    case FaultKind::kDelayed:
      return "delayed";
    case FaultKind::kIntermittent:
      return "intermittent";
    case FaultKind::kJump:
      return "jump";
  }
  return "";
}

std::string to_string(const Change& change) { return std::visit(Teller{}, change); }

}  // namespace amiss::world
