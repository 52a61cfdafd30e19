#include "mission/tour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mission/navigator.hpp"

namespace amiss::mission {
namespace {

constexpr double kFirstLook = 1.0;   // s of standing, so that the scan meets the map
constexpr double kHeadPeriod = 0.1;  // s between two commands of a slow sweep

bool never() { return false; }

/// Moves the head there no faster than the rate; false when the mission ended.
bool sweep_to(Navigator& navigator, const Perception& perception, const robot::HeadState& to, double rate_rad_s) {
  const robot::HeadState from = perception.head();
  const double way_rad = std::max(std::abs(to.pan_rad - from.pan_rad), std::abs(to.tilt_rad - from.tilt_rad));
  const int steps = std::max(1, static_cast<int>(std::ceil(way_rad / (rate_rad_s * kHeadPeriod))));
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const robot::HeadState head{from.pan_rad + part * (to.pan_rad - from.pan_rad),
                                from.tilt_rad + part * (to.tilt_rad - from.tilt_rad)};
    if (!navigator.stand(kHeadPeriod, head)) return false;
  }
  return true;
}

bool look_round(Navigator& navigator, const Perception& perception, const TourParams& tour) {
  const std::array<robot::HeadState, 5> turns{{{tour.pan_rad, tour.low_tilt_rad},
                                               {-tour.pan_rad, tour.low_tilt_rad},
                                               {-tour.pan_rad, tour.high_tilt_rad},
                                               {tour.pan_rad, tour.high_tilt_rad},
                                               {0.0, tour.high_tilt_rad}}};
  return std::all_of(turns.begin(), turns.end(), [&](const robot::HeadState& head) {
    return sweep_to(navigator, perception, head, tour.head_rate_rad_s);
  });
}

}  // namespace

void describe(ParamTable& table, TourParams& params) {
  table.number("tour.tolerance", params.tolerance_m, "m", 0.05, 1.0, "by which a waypoint may be moved");
  table.number("tour.pan", params.pan_rad, "deg", 0.0, 90.0, "of the head to both sides at a waypoint");
  table.number("tour.low_tilt", params.low_tilt_rad, "deg", -80.0, 0.0, "of the first sweep");
  table.number("tour.high_tilt", params.high_tilt_rad, "deg", -80.0, 20.0, "of the sweep back");
  table.number("tour.head_rate", params.head_rate_rad_s, "rad/s", 0.1, 1.0, "of the head in a sweep");
}

TourReport drive_tour(robot::Robot& robot, const Reference& reference, const Pose2<Map, Base>& start,
                      std::span<const Pose2<Map, Base>> waypoints, const Params& params, const TourParams& tour,
                      std::uint64_t seed, const Sinks& sinks) {
  localize::Localizer localizer(reference.floor, start, {0.05, radians(2.0)}, params.localizer,
                                RandomStream(seed, "tour/localizer"));
  Perception perception(robot, std::make_unique<LocalizerTracker>(std::move(localizer)), reference.floor,
                        params.voxels, params.perception, sinks);
  Navigator navigator(perception, reference.floor, {}, params.navigation, RandomStream(seed, "tour/paths"));
  TourReport report;
  bool goes_on = navigator.stand(kFirstLook, {0.0, params.navigation.navigator.head_tilt_rad});
  for (std::size_t i = 0; goes_on && i < waypoints.size(); ++i) {
    const DriveReport drive = navigator.drive_to(waypoints[i], tour.tolerance_m, never);
    if (drive.outcome == DriveOutcome::kArrived) {
      ++report.reached;
      goes_on = look_round(navigator, perception, tour);
    } else if (drive.outcome == DriveOutcome::kFailed) {
      report.left_out.push_back("waypoint " + std::to_string(i + 1) + ": " + drive.why);
      sinks.log(perception.now(), report.left_out.back());
    } else {
      goes_on = false;
    }
  }
  report.complete = goes_on;
  report.distance_m = perception.distance_m();
  report.ended = perception.now();
  return report;
}

}  // namespace amiss::mission
