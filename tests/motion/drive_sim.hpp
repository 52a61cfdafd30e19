// A robot of points and numbers for tests of the follower: limits of speed and acceleration, a laser by marching rays
// through the true grid, and a localization that is off by a few centimetres.
#pragma once

#include <optional>

#include "core/random.hpp"
#include "motion/follower.hpp"

namespace amiss::motion {

struct DriveSim {
  Pose2<Map, Base> pose;
  Eigen::Vector2d velocity_map = Eigen::Vector2d::Zero();
  double yaw_rate = 0.0;
  double noise_m = 0.0;
  RandomStream random{1, "sim"};
  Eigen::Vector2d slow_error = Eigen::Vector2d::Zero();

  static constexpr double kPeriod_s = 0.02;
  static constexpr double kLaserX_m = 0.1675;

  void move(const FollowStep& step, const robot::Limits& limits) {
    const double c = std::cos(pose.yaw_rad), s = std::sin(pose.yaw_rad);
    const Eigen::Vector2d v = step.velocity_base_m_s;
    const Eigen::Vector2d wanted(c * v.x() - s * v.y(), s * v.x() + c * v.y());
    Eigen::Vector2d change = wanted - velocity_map;
    const double most = limits.acceleration_m_s2 * kPeriod_s;
    if (change.norm() > most) change *= most / change.norm();
    velocity_map += change;
    const double turn = limits.yaw_acceleration_rad_s2 * kPeriod_s;
    yaw_rate += std::clamp(step.yaw_rate_rad_s - yaw_rate, -turn, turn);
    pose.x_m += velocity_map.x() * kPeriod_s;
    pose.y_m += velocity_map.y() * kPeriod_s;
    pose.yaw_rad = wrap_angle(pose.yaw_rad + yaw_rate * kPeriod_s);
  }

  [[nodiscard]] Pose2<Map, Base> estimate() {
    const double dx = random.normal(), dy = random.normal(), dyaw = random.normal();
    slow_error = 0.99 * slow_error + 0.14 * noise_m * Eigen::Vector2d(dx, dy);
    return {pose.x_m + slow_error.x(), pose.y_m + slow_error.y(), wrap_angle(pose.yaw_rad + 0.1 * noise_m * dyaw)};
  }

  [[nodiscard]] std::vector<Eigen::Vector2d> laser_base(const FloorGrid& truth) {
    std::vector<Eigen::Vector2d> hits;
    const Eigen::Vector2d eye =
        pose.position() + kLaserX_m * Eigen::Vector2d(std::cos(pose.yaw_rad), std::sin(pose.yaw_rad));
    for (double angle = -2.1; angle <= 2.1; angle += 4.2 / 240) {
      const Eigen::Vector2d ray(std::cos(pose.yaw_rad + angle), std::sin(pose.yaw_rad + angle));
      for (double range = 0.05; range < 4.0; range += 0.01) {
        if (truth.at(Eigen::Vector2d(eye + range * ray)) != Occupancy::kOccupied) continue;
        const double measured = range + (noise_m > 0.0 ? 0.01 * random.normal() : 0.0);
        hits.emplace_back(kLaserX_m + measured * std::cos(angle), measured * std::sin(angle));
        break;
      }
    }
    return hits;
  }
};

/// From the middle of the base to the nearest point of an occupied cell.
inline double true_gap_m(const FloorGrid& truth, const Eigen::Vector2d& p) {
  double gap = 10.0;
  const double half = 0.5 * truth.resolution_m();
  const Cell middle = truth.cell_at(p);
  for (int y = middle.y - 12; y <= middle.y + 12; ++y) {
    for (int x = middle.x - 12; x <= middle.x + 12; ++x) {
      if (truth.at(Cell{x, y}) != Occupancy::kOccupied) continue;
      const Eigen::Vector2d to = (truth.centre_of({x, y}) - p).cwiseAbs() - Eigen::Vector2d::Constant(half);
      gap = std::min(gap, to.cwiseMax(0.0).norm());
    }
  }
  return gap;
}

struct DriveLog {
  FollowStatus status = FollowStatus::kDriving;
  double time_s = 0.0;
  double least_gap_m = 10.0;
  double most_speed_m_s = 0.0;
  double most_change_m_s2 = 0.0;  // of the commands
};

/// Drives until the follower is done or the time is over. The laser sweeps every 100 ms.
inline DriveLog drive(Follower& follower, DriveSim& sim, const DriveMap& map, const FloorGrid& truth, double limit_s) {
  const robot::Limits limits;
  DriveLog log;
  std::vector<Eigen::Vector2d> hits;
  std::optional<Eigen::Vector2d> before;
  for (int tick = 0; log.time_s < limit_s; ++tick) {
    if (tick % 5 == 0) hits = sim.laser_base(truth);
    const double yaw = sim.pose.yaw_rad;
    const FollowStep step = follower.step(sim.estimate(), map, hits, duration_of(DriveSim::kPeriod_s));
    log.status = step.status;
    if (step.status != FollowStatus::kDriving) break;
    const Eigen::Vector2d command = Eigen::Rotation2Dd(yaw) * step.velocity_base_m_s;
    if (before) log.most_change_m_s2 = std::max(log.most_change_m_s2, (command - *before).norm() / DriveSim::kPeriod_s);
    before = command;
    log.most_speed_m_s = std::max(log.most_speed_m_s, command.norm());
    sim.move(step, limits);
    log.time_s += DriveSim::kPeriod_s;
    log.least_gap_m = std::min(log.least_gap_m, true_gap_m(truth, sim.pose.position()));
  }
  for (int i = 0; i < 60; ++i) sim.move({}, limits);  // rolls out
  return log;
}

}  // namespace amiss::motion
