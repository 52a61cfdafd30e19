// Rigid bodies of a world: things fall, roll, rest, are pushed and fall asleep (Bullet, fixed step).
// World -> poses of its bodies in the world frame, one step after the other; the same calls give the same bytes.
// Static meshes collide as triangles, meshes of moving bodies as their convex hull. A body without collision shapes
// stays where it is put; what overlaps fixed things from the start (a drawer in its frame) rests until it is touched.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/params.hpp"
#include "core/stamp.hpp"
#include "world/world.hpp"

namespace amiss::sim {

struct PhysicsParams {
  double step_s = 0.01;             // longest step of the solver
  double rolling_friction = 0.001;  // [m] per unit of friction: what stops a ball
  double linear_damping = 0.02;     // part of the velocity lost in a second
  double angular_damping = 0.10;
};
void describe(ParamTable& table, PhysicsParams& params);

class Physics {
 public:
  explicit Physics(const world::World& world, const PhysicsParams& params = {});
  ~Physics();
  Physics(Physics&&) noexcept;
  Physics& operator=(Physics&&) noexcept;

  /// A further body at its pose; the result is its index: those of the world come first, in their order.
  std::size_t add(const world::Body& body);
  /// The index stays taken, the body is gone.
  void remove(std::size_t body);
  /// Puts a body somewhere else, at rest and awake.
  void place(std::size_t body, const Transform<amiss::World, Object>& pose);

  /// Lets time pass; costs next to nothing while everything sleeps.
  void step(Duration dt);

  [[nodiscard]] std::size_t body_count() const;
  [[nodiscard]] bool is_present(std::size_t body) const;
  [[nodiscard]] bool is_static(std::size_t body) const;
  [[nodiscard]] const std::string& name(std::size_t body) const;
  [[nodiscard]] bool all_asleep() const;
  [[nodiscard]] bool is_asleep(std::size_t body) const;
  [[nodiscard]] const Transform<amiss::World, Object>& pose(std::size_t body) const;
  /// Bounds of the collision shapes in the world frame, empty where there are none.
  [[nodiscard]] Eigen::AlignedBox3d bounds(std::size_t body) const;
  /// Counts up whenever the pose of a moving body changes.
  [[nodiscard]] std::uint64_t revision(std::size_t body) const;

  /// Distance [m] from a moving body to the nearest other one that is not ground (static, no higher than 1 cm, or what
  /// it stands on), or nothing where that is more than `limit_m`. Negative: they overlap.
  [[nodiscard]] std::optional<double> distance_to_others(std::size_t body, double limit_m) const;

  struct RayHit {
    double range_m;
    std::size_t body;
  };
  [[nodiscard]] std::optional<RayHit> cast_ray(const Point<amiss::World>& from, const Point<amiss::World>& to) const;

  struct Impl;
  [[nodiscard]] Impl& impl() { return *impl_; }  // for robot_body.cpp

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace amiss::sim
