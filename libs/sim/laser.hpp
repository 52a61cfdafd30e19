// A planar laser: what the light meets at the laser's height, cut into segments once for static bodies and again for
// those that move. Bodies with visuals -> LaserScan with noise. Shapes one can see through (alpha below 0.99) are not
// hit.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/params.hpp"
#include "core/random.hpp"
#include "core/sensors.hpp"
#include "world/world.hpp"

namespace amiss::sim {

struct LaserParams {
  double period_s = 0.1;
  double half_angle_rad = 2.1;
  int beams = 721;
  double min_range_m = 0.05;
  double max_range_m = 20.0;
  double sigma_m = 0.01;  // of one beam
};
void describe(ParamTable& table, LaserParams& params);

/// A piece of a wall, as the laser's plane cuts it.
struct Segment2 {
  Eigen::Vector2d a, b;
};

/// Cuts the visuals of a body at a pose with the plane z = height (world frame).
[[nodiscard]] std::vector<Segment2> slice(const world::Body& body, const Transform<amiss::World, Object>& pose,
                                          double height_m);

class LaserScanner {
 public:
  /// The static bodies of the world are cut here; moving ones are set as they move.
  LaserScanner(const world::World& world, double height_m, const LaserParams& params);
  ~LaserScanner();
  LaserScanner(LaserScanner&&) noexcept;
  LaserScanner& operator=(LaserScanner&&) noexcept;

  /// A body that is not part of the static world, under a number of the caller's.
  void set_moving(std::size_t number, const world::Body& body, const Transform<amiss::World, Object>& pose);
  void remove_moving(std::size_t number);

  /// Ranges without noise; those outside of the limits are NaN.
  [[nodiscard]] LaserScan measure(Stamp stamp, const Pose2<amiss::World, Laser>& T_world_laser) const;
  [[nodiscard]] LaserScan measure(Stamp stamp, const Pose2<amiss::World, Laser>& T_world_laser,
                                  RandomStream& noise) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amiss::sim
