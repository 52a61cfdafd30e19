#include "mission/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace amiss::mission {

namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(20);
constexpr double kTurnRate = 1.0;        // rad/s, on the spot
constexpr double kTurnTolerance = 0.03;  // rad
constexpr double kMinClearance = 0.24;   // m, below which a path is given up on the way
constexpr double kLookAhead = 3.0;       // m of the path that is checked again
constexpr double kStuckAfter = 4.0;      // s without getting anywhere
constexpr double kMoved = 0.02;          // m, that is getting somewhere
constexpr double kTurned = 0.05;         // rad, too
constexpr double kPatience = 6.0;        // times as long as a drive should take, and
constexpr double kLeastPatience = 30.0;  // s, then it is given up
constexpr double kLookRoundRate = 0.5;   // rad/s
constexpr double kStandsOn = 0.15;       // m round the base's middle: free, though its own sensors never see it

constexpr int kDirections = 32;            // that backing off tries
constexpr double kBackOff = 0.15;          // m
constexpr double kBackOffSpeed = 0.1;      // m/s
constexpr double kWorthBackingOff = 0.03;  // m of clearance gained

DriveReport failure(NavigationError error, std::string why) { return {DriveOutcome::kFailed, error, std::move(why)}; }
const DriveReport kEnd{DriveOutcome::kEnded, {}, ""};

NavigationError error_of(motion::FollowStatus status) {
  return status == motion::FollowStatus::kOffPath ? NavigationError::kOffPath : NavigationError::kBlocked;
}

/// Does the robot get on? Something that no sensor shows may hold it.
class StuckWatch {
 public:
  explicit StuckWatch(const PoseEstimate& now) : last_(now) {}
  bool stuck(const PoseEstimate& now) {
    const Pose2<Base, Base> since = last_.T_map_base.inverse() * now.T_map_base;
    if (since.position().norm() > kMoved || std::abs(since.yaw_rad) > kTurned) last_ = now;
    return seconds(now.stamp - last_.stamp) > kStuckAfter;
  }

 private:
  PoseEstimate last_;
};

}  // namespace

void describe(ParamTable& table, NavigatorParams& p) {
  table.number("navigator.refresh", p.refresh_s, "s", 0.02, 5.0, "between two updates of the drive map");
  table.integer("navigator.attempts", p.attempts, 1, 20, "paths that are tried before a goal is given up");
  table.number("navigator.head_tilt", p.head_tilt_rad, "deg", -60.0, 0.0, "tilt of the head while driving");
}

void describe(ParamTable& table, NavigationParams& p) {
  describe(table, p.navigator);
  motion::describe(table, p.drive);
  motion::describe(table, p.planner);
  motion::describe(table, p.follower);
}

Navigator::Navigator(Perception& perception, const FloorGrid& floor, std::vector<const FloorGrid*> static_layers,
                     const NavigationParams& params, RandomStream random)
    : perception_(perception),
      static_layers_(std::move(static_layers)),
      params_(params),
      map_(floor, params.drive),
      follower_(perception.model().limits, params.follower),
      random_(random) {}

void Navigator::set_floor(const FloorGrid& floor) {
  map_.reset(floor);
  next_refresh_ = Stamp{};
}

const motion::DriveMap& Navigator::drive_map() {
  refresh();
  return map_;
}

motion::PathLengths Navigator::ways_from_here() { return {drive_map(), perception_.pose().T_map_base.position()}; }

void Navigator::refresh() {
  std::vector<const FloorGrid*> layers = static_layers_;
  layers.push_back(&perception_.obstacles().obstacles());
  map_.keep_free({perception_.pose().T_map_base.position()}, kStandsOn);
  map_.update(layers, perception_.laser_hits_map());
  next_refresh_ = perception_.now() + duration_of(params_.navigator.refresh_s);
}

std::vector<Eigen::Vector2d> Navigator::hits_base() const {
  const Eigen::Isometry3d T = perception_.pose().T_map_base.inverse().lift().T;
  std::vector<Eigen::Vector2d> hits;
  hits.reserve(perception_.laser_hits_map().size());
  for (const Eigen::Vector2d& hit : perception_.laser_hits_map()) {
    hits.emplace_back((T * Eigen::Vector3d(hit.x(), hit.y(), 0.0)).head<2>());
  }
  return hits;
}

DriveReport Navigator::drive_to(const Pose2<Map, Base>& goal, double tolerance_m,
                                const std::function<bool()>& pointless) {
  DriveReport report;
  motion::PlannerParams planner = params_.planner;
  planner.goal_tolerance_m = tolerance_m;
  for (int attempt = 0; attempt < params_.navigator.attempts; ++attempt) {
    refresh();
    const auto planned = motion::plan_path(map_, perception_.pose().T_map_base, goal, planner, random_);
    if (!planned) {
      report = failure(NavigationError::kNoPath, std::string(motion::to_string(planned.why())));
      if (!stand(params_.navigator.refresh_s, {0.0, params_.navigator.head_tilt_rad})) return kEnd;
      if (auto why = trouble()) return *why;
      continue;
    }
    perception_.sinks().path({perception_.now(), &planned->path});
    report = follow(planned->path, pointless);
    if (report.outcome != DriveOutcome::kFailed) return report;
    perception_.sinks().log(perception_.now(), "stopped on the way: " + report.why);
    if (trouble()) return report;
    if (!back_off()) return kEnd;
  }
  return report;
}

std::optional<DriveReport> Navigator::trouble() const {
  const auto now = heeds_trouble_ ? perception_.trouble() : std::nullopt;
  if (!now) return std::nullopt;
  const bool lost = now->complaint == Complaint::kLost;
  return failure(lost ? NavigationError::kLost : NavigationError::kSensorLost, to_string(*now));
}

bool Navigator::back_off() {
  refresh();
  const Eigen::Vector2d here = perception_.pose().T_map_base.position();
  if (map_.clearance_at(here) >= map_.params().robot_radius_m) return true;
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double most_m = map_.clearance_at(here) + kWorthBackingOff;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDirections;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    double clearance_m = map_.clearance_at(here);
    for (double way_m = 0.05; way_m <= kBackOff + 1e-9 && clearance_m > 0.0; way_m += 0.05) {
      const double next_m = map_.clearance_at(here + way_m * direction);
      clearance_m = next_m + 0.01 >= clearance_m ? next_m : 0.0;  // never nearer to anything on the way
    }
    if (clearance_m > most_m) {
      most_m = clearance_m;
      best = direction;
    }
  }
  if (best.isZero()) return true;
  robot::Command command;
  command.tilt_rad = params_.navigator.head_tilt_rad;
  const Stamp until = perception_.now() + duration_of(2.0 * kBackOff / kBackOffSpeed);
  while ((perception_.pose().T_map_base.position() - here).norm() < kBackOff && perception_.now() < until) {
    const Eigen::Rotation2Dd R_base_map(-perception_.pose().T_map_base.yaw_rad);
    command.velocity_base_m_s = kBackOffSpeed * (R_base_map * best);
    if (!perception_.step(command)) return false;
    if (perception_.bumper()) return true;
  }
  return true;
}

DriveReport Navigator::follow(motion::Path path, const std::function<bool()>& pointless) {
  follower_.start(std::move(path));
  robot::Command command;
  command.tilt_rad = params_.navigator.head_tilt_rad;
  StuckWatch watch(perception_.pose());
  const double expected_s = follower_.path().length_m() / params_.follower.speed_m_s;
  const Stamp until = perception_.now() + duration_of(std::max(kLeastPatience, kPatience * expected_s));
  while (true) {
    const motion::FollowStep next = follower_.step(perception_.pose().T_map_base, map_, hits_base(), kPeriod);
    command.velocity_base_m_s = next.velocity_base_m_s;
    command.yaw_rate_rad_s = next.yaw_rate_rad_s;
    if (!perception_.step(command)) return kEnd;
    if (auto why = trouble()) return *why;
    if (next.status == motion::FollowStatus::kArrived) return {};
    if (next.status != motion::FollowStatus::kDriving) {
      return failure(error_of(next.status), std::string(motion::to_string(next.status)));
    }
    if (watch.stuck(perception_.pose())) return failure(NavigationError::kHeld, "stuck");
    if (perception_.now() > until) return failure(NavigationError::kTimeout, "it takes too long");
    if (perception_.now() < next_refresh_) continue;
    if (pointless()) return {DriveOutcome::kPointless, {}, ""};
    refresh();  // after pointless(), which may have set another floor
    const bool blocked_ahead = motion::min_clearance_m(map_, follower_.path(), follower_.travelled_m()) < kMinClearance;
    if (blocked_ahead && next.remaining_m > 0.0 && next.free_ahead_m < kLookAhead) {
      return failure(NavigationError::kBlocked, "blocked ahead");
    }
  }
}

DriveReport Navigator::turn(double angle_rad) {
  robot::Command command;
  command.tilt_rad = params_.navigator.head_tilt_rad;
  double left = angle_rad;
  double yaw = perception_.pose().T_map_base.yaw_rad;
  const double expected_s = std::abs(angle_rad) / kTurnRate;
  const Stamp until = perception_.now() + duration_of(std::max(kLeastPatience, kPatience * expected_s));
  while (std::abs(left) > kTurnTolerance) {
    command.yaw_rate_rad_s = std::clamp(left * 2.0, -kTurnRate, kTurnRate);
    if (!perception_.step(command)) return kEnd;
    if (auto why = trouble()) return *why;
    if (perception_.now() > until) return failure(NavigationError::kTimeout, "it takes too long");
    const double now = perception_.pose().T_map_base.yaw_rad;
    left -= wrap_angle(now - yaw);
    yaw = now;
  }
  return {};
}

bool Navigator::look_round(double duration_s) {
  robot::Command command;
  command.yaw_rate_rad_s = kLookRoundRate;
  command.tilt_rad = params_.navigator.head_tilt_rad;
  const Stamp until = perception_.now() + duration_of(duration_s);
  while (perception_.now() < until) {
    if (!perception_.step(command)) return false;
  }
  return true;
}

bool Navigator::stand(double duration_s, const robot::HeadState& head) {
  robot::Command command;
  command.pan_rad = head.pan_rad;
  command.tilt_rad = head.tilt_rad;
  const Stamp until = perception_.now() + duration_of(duration_s);
  while (perception_.now() < until) {
    if (!perception_.step(command)) return false;
  }
  return true;
}

}  // namespace amiss::mission
