// Drives the base to a pose: path planning, following, and what to do when something is in the way.
// Pose wanted in the map frame -> outcome; looks where it drives and keeps clear of what the reference, the laser and
// the current voxel map show. Thesis 4.2.3 (the goto_waypoint action).
#pragma once

#include <functional>
#include <string>

#include "mission/perception.hpp"
#include "motion/drive_map.hpp"
#include "motion/follower.hpp"
#include "motion/path_lengths.hpp"
#include "motion/path_planner.hpp"

namespace amiss::mission {

struct NavigatorParams {
  double refresh_s = 0.5;  // between two updates of the drive map
  int attempts = 4;        // paths that are tried before a goal is given up
  double head_tilt_rad = -radians(32.0);
};
void describe(ParamTable& table, NavigatorParams& p);

struct NavigationParams {
  NavigatorParams navigator;
  motion::DriveParams drive;
  motion::PlannerParams planner;
  motion::FollowerParams follower;
};
void describe(ParamTable& table, NavigationParams& p);

enum class DriveOutcome { kArrived, kPointless, kFailed, kEnded };

struct DriveReport {
  DriveOutcome outcome = DriveOutcome::kArrived;
  NavigationError error = NavigationError::kNoPath;  // of a failure,
  std::string why;                                   // and in words
};

class Navigator {
 public:
  /// `static_layers`: what is known beforehand (the reference's obstacles); all arguments outlive the navigator.
  Navigator(Perception& perception, const FloorGrid& floor, std::vector<const FloorGrid*> static_layers,
            const NavigationParams& params, RandomStream random);

  /// Ends early when `pointless` says so. The goal may be moved by `tolerance_m` to where the robot can stand.
  DriveReport drive_to(const Pose2<Map, Base>& goal, double tolerance_m, const std::function<bool()>& pointless);
  /// Turns on the spot by the angle; the camera looks down in front.
  DriveReport turn(double angle_rad);
  /// Stands and looks for a while; false when the mission ended meanwhile.
  bool stand(double duration_s, const robot::HeadState& head);
  /// Turns slowly for a while, whatever the pose; false when the mission ended meanwhile.
  bool look_round(double duration_s);

  /// From now on trouble (perception.hpp) ends every drive and turn, as a failure.
  void heed_trouble() { heeds_trouble_ = true; }

  /// The floor changed (mapping run).
  void set_floor(const FloorGrid& floor);
  /// The drive map with everything seen so far.
  const motion::DriveMap& drive_map();
  /// Ways from where the robot stands.
  [[nodiscard]] motion::PathLengths ways_from_here();

 private:
  void refresh();
  /// Straight away from what is nearer than the robot's radius; false when the mission ended meanwhile.
  bool back_off();
  [[nodiscard]] std::vector<Eigen::Vector2d> hits_base() const;
  [[nodiscard]] std::optional<DriveReport> trouble() const;
  DriveReport follow(motion::Path path, const std::function<bool()>& pointless);

  Perception& perception_;
  std::vector<const FloorGrid*> static_layers_;
  NavigationParams params_;
  motion::DriveMap map_;
  motion::Follower follower_;
  RandomStream random_;
  Stamp next_refresh_;
  bool heeds_trouble_ = false;
};

}  // namespace amiss::mission
