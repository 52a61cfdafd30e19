// A flat of wall and furniture segments with a ray caster, a tour through its rooms, and noisy sensors: what the tests
// of localization drive through.
#pragma once

#include <limits>
#include <utility>

#include "core/floor_grid.hpp"
#include "core/random.hpp"
#include "core/sensors.hpp"

namespace amiss::testing {

struct Wall {
  Eigen::Vector2d a, b;
};

class Flat {
 public:
  /// 11 x 8.2 m, five rooms and doors, with furniture as the laser sees it: boxes and legs.
  static Flat furnished() {
    Flat flat;
    flat.box({0, 0}, {11, 8.2});
    // inner walls of 0.1 m with doors of 0.9 m
    flat.box({4.0, 0.0}, {4.1, 1.5});
    flat.box({4.0, 2.4}, {4.1, 5.0});
    flat.box({0.0, 5.0}, {1.6, 5.1});
    flat.box({2.5, 5.0}, {6.4, 5.1});
    flat.box({7.3, 5.0}, {9.0, 5.1});
    flat.box({9.9, 5.0}, {11.0, 5.1});
    flat.box({7.5, 0.0}, {7.6, 2.0});
    flat.box({7.5, 2.9}, {7.6, 5.0});
    flat.box({5.2, 5.1}, {5.3, 8.2});
    flat.box({0.3, 0.3}, {2.2, 1.2});  // sofa
    flat.box({0.0, 3.1}, {0.45, 4.3});
    flat.box({5.0, 0.0}, {6.6, 0.6});
    flat.box({9.2, 1.2}, {10.9, 3.2});  // bed
    flat.box({0.2, 7.6}, {2.8, 8.1});
    flat.box({8.3, 7.7}, {10.2, 8.2});
    flat.legs({5.3, 3.2}, {6.7, 4.1});  // table
    flat.legs({2.4, 2.9}, {2.9, 3.4});  // chair
    flat.legs({7.3, 6.9}, {8.5, 7.6});
    return flat;
  }

  void box(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    const Eigen::Vector2d c(high.x(), low.y()), d(low.x(), high.y());
    for (const auto& [a, b] : {std::pair{low, c}, std::pair{c, high}, std::pair{high, d}, std::pair{d, low}}) {
      walls_.push_back({a, b});
    }
  }
  void legs(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    const Eigen::Vector2d leg(0.05, 0.05);
    box(low, low + leg);
    box(high - leg, high);
    box({low.x(), high.y() - 0.05}, {low.x() + 0.05, high.y()});
    box({high.x() - 0.05, low.y()}, {high.x(), low.y() + 0.05});
  }
  [[nodiscard]] const std::vector<Wall>& walls() const { return walls_; }

  /// Distance along the ray to the first wall, infinity where there is none.
  [[nodiscard]] double cast(const Eigen::Vector2d& from, double angle_rad) const {
    const Eigen::Vector2d dir(std::cos(angle_rad), std::sin(angle_rad));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls_) {
      const Eigen::Vector2d along = wall.b - wall.a, to = wall.a - from;
      const double cross = dir.x() * along.y() - dir.y() * along.x();
      if (std::abs(cross) < 1e-12) continue;
      const double t = (to.x() * along.y() - to.y() * along.x()) / cross;
      const double u = (to.x() * dir.y() - to.y() * dir.x()) / cross;
      if (t > 0.0 && u >= 0.0 && u <= 1.0) nearest = std::min(nearest, t);
    }
    return nearest;
  }

  /// Cells that a wall crosses are occupied, the others free.
  [[nodiscard]] FloorGrid grid(double resolution_m = 0.05) const {
    FloorGrid grid(resolution_m, {-0.52, -0.53}, static_cast<int>(12.1 / resolution_m),
                   static_cast<int>(9.3 / resolution_m), Occupancy::kFree);
    for (const Wall& wall : walls_) {
      const double length = (wall.b - wall.a).norm();
      for (double s = 0.0; s <= length; s += 0.005) {
        const Cell cell = grid.cell_at(wall.a + (wall.b - wall.a) * (s / length));
        if (grid.contains(cell)) grid.set(cell, Occupancy::kOccupied);
      }
    }
    return grid;
  }

 private:
  std::vector<Wall> walls_;
};

/// What the robot measures on a drive: at 50 Hz the odometry, every fifth time a scan.
struct Drive {
  struct Step {
    Pose2<World, Base> truth;
    Odometry odometry;
    bool has_scan = false;
    LaserScan scan;
  };
  std::vector<Step> steps;
};

[[nodiscard]] inline Transform<Base, Laser> laser_mount() {
  Transform<Base, Laser> T;
  T.T.translation() = Eigen::Vector3d(0.1675, 0.0, 0.184);
  return T;
}

[[nodiscard]] inline LaserScan scan_from(const Flat& flat, const Pose2<World, Base>& truth, Stamp stamp,
                                         RandomStream& random) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.angle_min_rad = -2.1;
  scan.angle_step_rad = 4.2 / 720.0;
  scan.min_range_m = 0.05;
  scan.max_range_m = 20.0;
  const Eigen::Vector2d at = truth.position() + Eigen::Rotation2Dd(truth.yaw_rad) * Eigen::Vector2d(0.1675, 0.0);
  for (int i = 0; i < 721; ++i) {
    const double range_m = flat.cast(at, truth.yaw_rad + scan.angle_min_rad + i * scan.angle_step_rad);
    scan.ranges_m.push_back(static_cast<float>(range_m + 0.01 * random.normal()));
  }
  return scan;
}

/// Drives through the points at 0.3 m/s and 1 rad/s, turning towards each on the spot first. Odometry errs by 3 % of
/// every step at random and by a fixed scale of 1.5 %.
[[nodiscard]] inline Drive drive(const Flat& flat, const std::vector<Eigen::Vector2d>& way, std::uint64_t seed) {
  RandomStream random(seed, "drive");
  RandomStream laser(seed, "laser");
  Drive out;
  Pose2<World, Base> truth{way.front().x(), way.front().y(), 0.0};
  Pose2<Odom, Base> odom;
  const double scale = 1.0 + 0.015 * random.normal(), turn_scale = 1.0 + 0.015 * random.normal();
  const auto step = [&](double forward_m, double turn_rad) {
    truth = truth * Pose2<Base, Base>{forward_m, 0.0, turn_rad};
    const double noisy_m = forward_m * scale * (1.0 + 0.1 * random.normal());
    const double noisy_rad = turn_rad * turn_scale * (1.0 + 0.1 * random.normal()) + 0.02 * forward_m * random.normal();
    odom = odom * Pose2<Base, Base>{noisy_m, 0.1 * forward_m * random.normal(), noisy_rad};
    Drive::Step now;
    now.truth = truth;
    now.odometry = {Stamp(std::chrono::milliseconds(20 * static_cast<int>(out.steps.size()))), odom};
    now.has_scan = out.steps.size() % 5 == 0;
    if (now.has_scan) now.scan = scan_from(flat, truth, now.odometry.stamp, laser);
    out.steps.push_back(std::move(now));
  };
  for (std::size_t i = 1; i < way.size(); ++i) {
    const auto bearing = [&] {
      const Eigen::Vector2d to = way[i] - truth.position();
      return wrap_angle(std::atan2(to.y(), to.x()) - truth.yaw_rad);
    };
    while (std::abs(bearing()) > 0.021) step(0.0, std::clamp(bearing(), -0.02, 0.02));
    while ((way[i] - truth.position()).norm() > 0.01) step(0.006, std::clamp(bearing(), -0.01, 0.01));
  }
  return out;
}

/// Through all rooms and back to the start.
[[nodiscard]] inline std::vector<Eigen::Vector2d> tour() {
  return {{3.2, 2.0},  {3.5, 1.95}, {4.8, 1.95}, {7.0, 2.4}, {8.4, 2.45}, {8.4, 4.4},  {8.4, 2.45}, {7.0, 2.4},
          {6.85, 4.5}, {6.85, 5.8}, {8.9, 6.2},  {9.8, 6.8}, {6.4, 6.0},  {6.85, 5.4}, {6.85, 2.4}, {4.7, 1.95},
          {3.4, 1.95}, {2.0, 3.9},  {2.05, 5.6}, {3.9, 6.6}, {2.05, 5.7}, {2.05, 4.0}, {1.4, 2.2},  {3.2, 2.0}};
}

}  // namespace amiss::testing
