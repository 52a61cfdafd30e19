#include "motion/follower.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "motion/internal/free_ahead.hpp"

namespace amiss::motion {
namespace {

constexpr std::array<double, 4> kLookAhead_m{0.60, 0.40, 0.25, 0.12};
constexpr double kSearch_m = 0.60;              // of the path ahead in which the nearest point is sought
constexpr double kFinalTurn_m = 0.35;           // before its end the robot may already turn to the final heading
constexpr double kFullSpeed_rad = radians(20);  // of heading error that does not slow down
constexpr double kKeep_m = 0.02;                // left over in front of something
constexpr double kSideRange_m = 0.06;           // beyond the stop radius: something there pushes away
constexpr double kSidePush = 0.5;
constexpr double kCreep_m_s = 0.02;  // slower is standing
constexpr double kStanding_m_s = 2.0 * kCreep_m_s;
constexpr double kBrake = 0.8;         // part of the acceleration that braking counts on
constexpr double kNearGain_1_s = 2.5;  // speed for distance, close to the goal

Eigen::Vector2d rotated(const Eigen::Vector2d& v, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

double speed_to_stop_within(double distance_m, double acceleration_m_s2) {
  return std::sqrt(2.0 * kBrake * acceleration_m_s2 * std::max(0.0, distance_m));
}

}  // namespace

void describe(ParamTable& table, FollowerParams& p) {
  table.number("follow.speed", p.speed_m_s, "m/s", 0.02, 2.0, "of driving");
  table.number("follow.acceleration", p.acceleration_m_s2, "m/s^2", 0.05, 5.0, "of driving and braking");
  table.number("follow.yaw_rate", p.yaw_rate_rad_s, "rad/s", 0.1, 5.0, "of turning");
  table.number("follow.yaw_acceleration", p.yaw_acceleration_rad_s2, "rad/s^2", 0.1, 20.0, "of turning");
  table.number("follow.position_tolerance", p.position_tolerance_m, "m", 0.005, 0.5, "of arriving");
  table.number("follow.yaw_tolerance", p.yaw_tolerance_rad, "deg", 0.2, 90.0, "of arriving");
  table.number("follow.stop_radius", p.stop_radius_m, "m", 0.1, 1.0, "nothing may come nearer to the base's middle");
  table.number("follow.slow_clearance", p.slow_clearance_m, "m", 0.1, 2.0, "slower where it is narrower");
  table.number("follow.turn_first", p.turn_first_rad, "deg", 10.0, 180.0, "heading error to turn away before driving");
  table.number("follow.off_path", p.off_path_m, "m", 0.05, 5.0, "distance from the path that needs a new one");
  table.number("follow.blocked_after", p.blocked_after_s, "s", 0.0, 60.0, "standing in front of something");
}

std::string_view to_string(FollowStatus status) {
  switch (status) {
    case FollowStatus::kDriving:
      return "driving";
    case FollowStatus::kArrived:
      return "arrived";
    case FollowStatus::kBlocked:
      return "blocked";
    case FollowStatus::kOffPath:
      return "off_path";
  }
  return "";
}

Follower::Follower(const robot::Limits& limits, FollowerParams params) : params_(params) {
  params_.speed_m_s = std::min(params_.speed_m_s, limits.speed_m_s);
  params_.acceleration_m_s2 = std::min(params_.acceleration_m_s2, limits.acceleration_m_s2);
  params_.yaw_rate_rad_s = std::min(params_.yaw_rate_rad_s, limits.yaw_rate_rad_s);
  params_.yaw_acceleration_rad_s2 = std::min(params_.yaw_acceleration_rad_s2, limits.yaw_acceleration_rad_s2);
}

void Follower::start(Path path) {
  assert(!path.points_m.empty());
  path_ = std::move(path);
  arc_m_.assign(1, 0.0);
  for (std::size_t i = 1; i < path_.points_m.size(); ++i) {
    arc_m_.push_back(arc_m_.back() + (path_.points_m[i] - path_.points_m[i - 1]).norm());
  }
  along_m_ = 0.0;
  blocked_s_ = 0.0;
  at_goal_ = false;
}

Eigen::Vector2d Follower::point_at(double along_m) const {
  const auto after = std::upper_bound(arc_m_.begin(), arc_m_.end(), along_m);
  if (after == arc_m_.begin()) return path_.points_m.front();
  if (after == arc_m_.end()) return path_.points_m.back();
  const auto i = static_cast<std::size_t>(after - arc_m_.begin());
  const double part = (along_m - arc_m_[i - 1]) / (arc_m_[i] - arc_m_[i - 1]);
  return path_.points_m[i - 1] + part * (path_.points_m[i] - path_.points_m[i - 1]);
}

/// The nearest point of the path, from where the robot was on it to a little further on. Returns the distance to it.
double Follower::advance(const Eigen::Vector2d& position) {
  double best_m = (point_at(along_m_) - position).norm();
  double best_along_m = along_m_;
  for (std::size_t i = 1; i < arc_m_.size() && arc_m_[i - 1] <= along_m_ + kSearch_m; ++i) {
    if (arc_m_[i] < along_m_ || arc_m_[i] <= arc_m_[i - 1]) continue;
    const Eigen::Vector2d leg = path_.points_m[i] - path_.points_m[i - 1];
    const double part = std::clamp((position - path_.points_m[i - 1]).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
    const double along_m = std::clamp(arc_m_[i - 1] + part * leg.norm(), along_m_, along_m_ + kSearch_m);
    const double d = (point_at(along_m) - position).norm();
    if (d < best_m) {
      best_m = d;
      best_along_m = along_m;
    }
  }
  along_m_ = best_along_m;
  return best_m;
}

/// The farthest point of the path ahead that can be headed for without coming nearer to anything than the path does.
Eigen::Vector2d Follower::carrot(const Eigen::Vector2d& position, const DriveMap& map) const {
  const double needed_m =
      std::min(map.params().robot_radius_m, map.clearance_at(position)) - 0.5 * map.grid().resolution_m();
  for (const double ahead_m : kLookAhead_m) {
    const Eigen::Vector2d target = point_at(along_m_ + ahead_m);
    const double length_m = (target - position).norm();
    if (internal::free_by_map_m(map, position, target, needed_m) >= length_m) return target;
  }
  return point_at(along_m_ + kLookAhead_m.back());
}

/// Fast where it is wide, slow before the goal, corners and wherever the robot does not look yet.
double Follower::wanted_speed(const Eigen::Vector2d& position, const DriveMap& map, double heading_error_rad,
                              double carrot_m) const {
  const double a = params_.acceleration_m_s2;
  double speed = params_.speed_m_s;
  const double goal_m = std::max((path_.points_m.back() - position).norm(), arc_m_.back() - along_m_);
  speed = std::min({speed, speed_to_stop_within(goal_m, a), std::max(kCreep_m_s, kNearGain_1_s * goal_m)});
  if (carrot_m < goal_m) speed = std::min(speed, std::sqrt(a * std::max(carrot_m, kLookAhead_m.back())));
  const double room = (map.clearance_at(position) - params_.stop_radius_m) /
                      std::max(0.01, params_.slow_clearance_m - params_.stop_radius_m);
  speed *= std::clamp(room, 0.35, 1.0);
  const double turn =
      (params_.turn_first_rad - std::abs(heading_error_rad)) / std::max(1e-3, params_.turn_first_rad - kFullSpeed_rad);
  return speed * std::clamp(turn, 0.0, 1.0);
}

double Follower::free_along(const Pose2<Map, Base>& pose, const Eigen::Vector2d& direction_map, const DriveMap& map,
                            std::span<const Eigen::Vector2d> hits_base) const {
  const double v = params_.speed_m_s;
  const double look_m = v * v / (2.0 * kBrake * params_.acceleration_m_s2) + 2.0 * params_.stop_radius_m;
  const double by_hits =
      internal::free_by_hits_m(hits_base, rotated(direction_map, -pose.yaw_rad), params_.stop_radius_m, look_m);
  const Eigen::Vector2d from = pose.position();
  return std::min(by_hits, internal::free_by_map_m(map, from, from + look_m * direction_map, params_.stop_radius_m));
}

void Follower::turn_towards(double yaw_error_rad, double dt_s) {
  const double error = std::abs(yaw_error_rad);
  const double stop = std::sqrt(2.0 * kBrake * params_.yaw_acceleration_rad_s2 * error);
  const double rate = std::copysign(std::min({params_.yaw_rate_rad_s, stop, 4.0 * error}), yaw_error_rad);
  const double most = params_.yaw_acceleration_rad_s2 * dt_s;
  yaw_rate_rad_s_ += std::clamp(rate - yaw_rate_rad_s_, -most, most);
}

void Follower::move_with(const Eigen::Vector2d& velocity_map, double dt_s) {
  const Eigen::Vector2d change = velocity_map - velocity_map_m_s_;
  const double most = params_.acceleration_m_s2 * dt_s;
  velocity_map_m_s_ += change.norm() > most ? Eigen::Vector2d(change * (most / change.norm())) : change;
}

FollowStep Follower::stop(FollowStatus status) {
  velocity_map_m_s_.setZero();
  yaw_rate_rad_s_ = 0.0;
  return {status, Eigen::Vector2d::Zero(), 0.0, arc_m_.back() - along_m_, 0.0};
}

/// Where to move, a unit vector of the map frame: to the carrot, pushed aside by what is near on one side.
Eigen::Vector2d Follower::direction_to(const Eigen::Vector2d& target, const Pose2<Map, Base>& pose,
                                       std::span<const Eigen::Vector2d> hits_base) const {
  const Eigen::Vector2d way = target - pose.position();
  if (way.norm() < 1e-6) return rotated(Eigen::Vector2d::UnitX(), pose.yaw_rad);
  const Eigen::Vector2d direction = way.normalized();
  const Eigen::Vector2d away_base = internal::away_from_sides(
      hits_base, rotated(direction, -pose.yaw_rad), params_.stop_radius_m, params_.stop_radius_m + kSideRange_m);
  return (direction + kSidePush * rotated(away_base, pose.yaw_rad)).normalized();
}

/// The wanted speed, or less: it must be able to stop before what lies in the direction, and before what lies where it
/// is rolling to until the direction has changed.
Follower::Allowed Follower::allowed_speed(double wanted, const Eigen::Vector2d& direction, const Pose2<Map, Base>& pose,
                                          const DriveMap& map, std::span<const Eigen::Vector2d> hits_base) const {
  const double a = params_.acceleration_m_s2;
  Allowed allowed;
  allowed.free_m = free_along(pose, direction, map, hits_base);
  allowed.speed_m_s = std::min(wanted, speed_to_stop_within(allowed.free_m - kKeep_m, a));
  const double rolling = velocity_map_m_s_.norm();
  if (rolling <= kStanding_m_s) return allowed;
  const double rolling_m = free_along(pose, velocity_map_m_s_ / rolling, map, hits_base);
  const double braking = speed_to_stop_within(rolling_m - kKeep_m, a);
  if (braking < rolling) allowed.speed_m_s = std::min(allowed.speed_m_s, braking);
  allowed.free_m = std::min(allowed.free_m, rolling_m);
  return allowed;
}

FollowStep Follower::step(const Pose2<Map, Base>& T_map_base, const DriveMap& map,
                          std::span<const Eigen::Vector2d> hits_base, Duration period) {
  assert(!arc_m_.empty());
  const double dt_s = seconds(period);
  const Eigen::Vector2d position = T_map_base.position();
  if (!position.allFinite() || !std::isfinite(T_map_base.yaw_rad)) return stop(FollowStatus::kOffPath);
  if (advance(position) > params_.off_path_m) return stop(FollowStatus::kOffPath);

  const double goal_m = (path_.points_m.back() - position).norm();
  const double remaining_m = arc_m_.back() - along_m_;
  const double final_error = wrap_angle(path_.final_yaw_rad - T_map_base.yaw_rad);
  at_goal_ = remaining_m <= kLookAhead_m.back() &&
             goal_m <= (at_goal_ ? 2.0 : 1.0) * params_.position_tolerance_m;  // hysteresis against a noisy pose
  const bool standing = velocity_map_m_s_.norm() <= kStanding_m_s;
  if (at_goal_ && standing && std::abs(final_error) <= params_.yaw_tolerance_rad) return stop(FollowStatus::kArrived);

  const Eigen::Vector2d ahead = point_at(along_m_ + kLookAhead_m.front()) - position;
  const bool final_turn = std::max(remaining_m, goal_m) <= kFinalTurn_m;
  const double heading_error = wrap_angle(std::atan2(ahead.y(), ahead.x()) - T_map_base.yaw_rad);
  turn_towards(final_turn ? final_error : heading_error, dt_s);

  const Eigen::Vector2d target = carrot(position, map);
  const Eigen::Vector2d direction = direction_to(target, T_map_base, hits_base);
  const double wanted =
      at_goal_ ? 0.0 : wanted_speed(position, map, final_turn ? 0.0 : heading_error, (target - position).norm());
  const Allowed allowed = allowed_speed(wanted, direction, T_map_base, map, hits_base);
  move_with(allowed.speed_m_s * direction, dt_s);

  const bool held = wanted > kCreep_m_s && allowed.speed_m_s <= kCreep_m_s;
  blocked_s_ = held ? blocked_s_ + dt_s : 0.0;
  if (blocked_s_ > params_.blocked_after_s) return stop(FollowStatus::kBlocked);
  return {FollowStatus::kDriving, rotated(velocity_map_m_s_, -T_map_base.yaw_rad), yaw_rate_rad_s_, remaining_m,
          allowed.free_m};
}

}  // namespace amiss::motion
