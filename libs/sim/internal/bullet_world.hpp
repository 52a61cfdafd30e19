// The state behind Physics: Bullet's world and what belongs to each body. For physics.cpp and robot_body.cpp.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/internal/bullet_shapes.hpp"
#include "sim/physics.hpp"

namespace amiss::sim {

inline constexpr double kGroundTop_m = 0.01;  // static shapes up to here are ground

/// One of Bullet's bodies and the shapes that it is made of.
struct Solid {
  std::vector<std::shared_ptr<btCollisionShape>> shapes;  // the last one is the body's
  std::unique_ptr<btRigidBody> rigid;
  Eigen::Isometry3d T_body_solid = Eigen::Isometry3d::Identity();  // of moving bodies: to the centre of mass
  bool is_ground = false;
};

struct BodyEntry {
  std::string name;
  bool is_static = true, is_present = true;
  Transform<amiss::World, Object> pose;
  std::uint64_t revision = 0;
  Eigen::Isometry3d still_at = Eigen::Isometry3d::Identity();  // within a few millimetres of this pose ..
  double still_s = 0.0;                                        // .. for so long
  std::vector<Solid> solids;  // one for each shape of a static body, at most one of a moving one
};

/// Tight bounds in the world frame.
namespace internal {
[[nodiscard]] Eigen::AlignedBox3d bounds_of(const Solid& solid);
}

/// The nearest points of two solids; the normal points from `body`'s to the probe's.
struct Nearest {
  double distance_m;
  std::size_t body;
  Eigen::Vector3d position, normal;
};

struct Physics::Impl {
  explicit Impl(const PhysicsParams& params);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  PhysicsParams params;
  internal::BulletShapes shapes;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld bullet;
  std::vector<BodyEntry> bodies;
  std::vector<std::size_t> movable;  // indices of moving bodies with solids

  void add_solids(BodyEntry& entry, const world::Body& body, int index);
  void take_out(BodyEntry& entry);
  void wake_around(const BodyEntry& entry);
  void substep(double dt_s);
  void read_poses(double elapsed_s);
  /// What overlaps fixed things from the start (a drawer in its frame, taken by its hull) rests until it is touched.
  void rest_what_is_wedged();
  void still_to_sleep(BodyEntry& entry, double elapsed_s);

  /// Calls `visit` for every pair of near points of the probe and the solids that `accept` lets through.
  using Accept = std::function<bool(const BodyEntry&, const Solid&)>;
  void visit_near(btCollisionObject& probe, double limit_m, const Accept& accept,
                  const std::function<void(const Nearest&)>& visit);
  [[nodiscard]] BodyEntry* entry_of(const btCollisionObject* object);
};

/// Is this pair of near points the probe standing on the floor?
[[nodiscard]] inline bool is_standing(const Nearest& near) {
  return near.position.z() < 2.0 * kGroundTop_m && std::abs(near.normal.z()) > 0.7;
}

}  // namespace amiss::sim
