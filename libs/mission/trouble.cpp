#include "mission/trouble.hpp"

namespace amiss::mission {

namespace {

std::string_view word_of(Sense sense) {
  switch (sense) {
    case Sense::kCamera:
      return "camera";
    case Sense::kLaser:
      return "laser";
    case Sense::kOdometry:
      return "odometry";
    case Sense::kPose:
      return "pose";
  }
  return "";
}

std::string_view word_of(Complaint complaint) {
  switch (complaint) {
    case Complaint::kSilent:
      return "silent";
    case Complaint::kStuck:
      return "stuck";
    case Complaint::kGarbage:
      return "garbage";
    case Complaint::kWrong:
      return "wrong";
    case Complaint::kLost:
      return "lost";
  }
  return "";
}

}  // namespace

void describe(ParamTable& table, HealthParams& p) {
  table.number("health.silent", p.silent_s, "s", 0.1, 600.0, "without a measurement, then a sensor is silent");
  table.number("health.lost_after", p.lost_after_s, "s", 0.1, 600.0, "without a believed pose, then the robot is lost");
  table.number("health.patience", p.patience_s, "s", 0.0, 3600.0, "that a search waits for a sensor");
  table.number("health.lost_patience", p.lost_patience_s, "s", 0.0, 3600.0, "that a search looks round for its pose");
}

std::string to_string(const Trouble& trouble) {
  return std::string(word_of(trouble.sense)) + " " + std::string(word_of(trouble.complaint));
}

std::string_view to_string(NavigationError error) {
  switch (error) {
    case NavigationError::kNoPath:
      return "no_path";
    case NavigationError::kBlocked:
      return "blocked";
    case NavigationError::kOffPath:
      return "off_path";
    case NavigationError::kHeld:
      return "held";
    case NavigationError::kTimeout:
      return "timeout";
    case NavigationError::kLost:
      return "lost";
    case NavigationError::kSensorLost:
      return "sensor_lost";
  }
  return "";
}

}  // namespace amiss::mission
