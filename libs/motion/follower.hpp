// Path -> Command, 50 times a second, for an omnidirectional base: smooth, facing where it goes, never into what the
// grid or the laser says is occupied. Poses in the map frame, laser hits in the base frame, metres and radians.
#pragma once

#include <span>
#include <string_view>

#include "core/stamp.hpp"
#include "motion/path.hpp"
#include "robot/model.hpp"

namespace amiss::motion {

struct FollowerParams {
  double speed_m_s = 0.3;
  double acceleration_m_s2 = 0.3;
  double yaw_rate_rad_s = 1.2;
  double yaw_acceleration_rad_s2 = 2.0;
  double position_tolerance_m = 0.03;
  double yaw_tolerance_rad = radians(2.0);
  double stop_radius_m = 0.26;     // nothing may come nearer to the middle of the base
  double slow_clearance_m = 0.40;  // slower where it is narrower than this
  double turn_first_rad = radians(60);
  double off_path_m = 0.40;
  double blocked_after_s = 0.6;  // of standing in front of something
};
void describe(ParamTable& table, FollowerParams& params);

enum class FollowStatus { kDriving, kArrived, kBlocked, kOffPath };
[[nodiscard]] std::string_view to_string(FollowStatus status);

struct FollowStep {
  FollowStatus status = FollowStatus::kDriving;
  Eigen::Vector2d velocity_base_m_s = Eigen::Vector2d::Zero();  // zero unless driving
  double yaw_rate_rad_s = 0.0;
  double remaining_m = 0.0;   // along the path
  double free_ahead_m = 0.0;  // until the stop radius would be touched, as far as was looked
};

class Follower {
 public:
  /// Limits of the robot bound the parameters.
  Follower(const robot::Limits& limits, FollowerParams params);

  void start(Path path);
  /// To be called once in a control period. `hits_base`: laser_hits(), in the base frame.
  [[nodiscard]] FollowStep step(const Pose2<Map, Base>& T_map_base, const DriveMap& map,
                                std::span<const Eigen::Vector2d> hits_base, Duration period);
  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] double travelled_m() const { return along_m_; }  // on the path, from its beginning

 private:
  [[nodiscard]] Eigen::Vector2d point_at(double along_m) const;
  double advance(const Eigen::Vector2d& position);
  [[nodiscard]] Eigen::Vector2d carrot(const Eigen::Vector2d& position, const DriveMap& map) const;
  [[nodiscard]] double wanted_speed(const Eigen::Vector2d& position, const DriveMap& map, double heading_error_rad,
                                    double carrot_m) const;
  [[nodiscard]] double free_along(const Pose2<Map, Base>& pose, const Eigen::Vector2d& direction_map,
                                  const DriveMap& map, std::span<const Eigen::Vector2d> hits_base) const;
  [[nodiscard]] Eigen::Vector2d direction_to(const Eigen::Vector2d& target, const Pose2<Map, Base>& pose,
                                             std::span<const Eigen::Vector2d> hits_base) const;
  struct Allowed {
    double speed_m_s = 0.0, free_m = 0.0;
  };
  [[nodiscard]] Allowed allowed_speed(double wanted, const Eigen::Vector2d& direction, const Pose2<Map, Base>& pose,
                                      const DriveMap& map, std::span<const Eigen::Vector2d> hits_base) const;
  void turn_towards(double yaw_error_rad, double dt_s);
  void move_with(const Eigen::Vector2d& velocity_map, double dt_s);
  FollowStep stop(FollowStatus status);

  FollowerParams params_;
  Path path_;
  std::vector<double> arc_m_;  // length up to each corner
  double along_m_ = 0.0;
  Eigen::Vector2d velocity_map_m_s_ = Eigen::Vector2d::Zero();
  double yaw_rate_rad_s_ = 0.0;
  double blocked_s_ = 0.0;
  bool at_goal_ = false;
};

}  // namespace amiss::motion
