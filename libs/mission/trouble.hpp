// What keeps a robot from going on safely: a sensor that is not to be believed, or a pose that is not known. Told by
// who watches what arrives (laser_health, camera_health, odometer, perception); a search stops, waits, and ends
// honestly when it does not pass.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/params.hpp"
#include "core/stamp.hpp"

namespace amiss::mission {

struct HealthParams {
  double silent_s = 1.5;          // without a measurement
  double lost_after_s = 2.0;      // without a pose that may be believed
  double patience_s = 15.0;       // that a search stands and waits for a sensor
  double lost_patience_s = 40.0;  // that it looks round for where it is
};
void describe(ParamTable& table, HealthParams& p);

enum class Sense { kCamera, kLaser, kOdometry, kPose };
enum class Complaint { kSilent, kStuck, kGarbage, kWrong, kLost };

struct Trouble {
  Sense sense = Sense::kPose;
  Complaint complaint = Complaint::kLost;
  Stamp since;
};
/// "laser stuck"; "pose lost": the scans fit the map nowhere
[[nodiscard]] std::string to_string(const Trouble& trouble);

/// Why a goal was not reached.
enum class NavigationError { kNoPath, kBlocked, kOffPath, kHeld, kTimeout, kLost, kSensorLost };
inline constexpr NavigationError kNavigationErrors[] = {
    NavigationError::kNoPath,  NavigationError::kBlocked, NavigationError::kOffPath,   NavigationError::kHeld,
    NavigationError::kTimeout, NavigationError::kLost,    NavigationError::kSensorLost};
[[nodiscard]] std::string_view to_string(NavigationError error);

}  // namespace amiss::mission
