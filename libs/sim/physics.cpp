#include "sim/physics.hpp"

#include <cmath>

#include "sim/internal/bullet_world.hpp"

namespace amiss::sim {

void describe(ParamTable& table, PhysicsParams& params) {
  table.number("physics.step", params.step_s, "s", 0.001, 0.02, "longest step of the solver");
  table.number("physics.rolling_friction", params.rolling_friction, "m", 0.0, 0.1, "resistance to rolling");
  table.number("physics.linear_damping", params.linear_damping, "", 0.0, 0.9, "part of the speed lost in a second");
  table.number("physics.angular_damping", params.angular_damping, "", 0.0, 0.9, "part of the spin lost in a second");
}

Physics::Physics(const world::World& world, const PhysicsParams& params) : impl_(std::make_unique<Impl>(params)) {
  impl_->bodies.reserve(world.bodies.size());
  for (const world::Body& body : world.bodies) add(body);
  impl_->rest_what_is_wedged();
}
Physics::~Physics() = default;
Physics::Physics(Physics&&) noexcept = default;
Physics& Physics::operator=(Physics&&) noexcept = default;

std::size_t Physics::add(const world::Body& body) {
  const std::size_t index = impl_->bodies.size();
  BodyEntry& entry = impl_->bodies.emplace_back();
  entry.name = body.name;
  entry.is_static = body.is_static;
  entry.pose = body.pose;
  impl_->add_solids(entry, body, static_cast<int>(index));
  if (!body.is_static && !entry.solids.empty()) impl_->movable.push_back(index);
  return index;
}

void Physics::remove(std::size_t body) {
  BodyEntry& entry = impl_->bodies[body];
  impl_->wake_around(entry);
  impl_->take_out(entry);
  std::erase(impl_->movable, body);
  entry.is_present = false;
  ++entry.revision;
}

void Physics::place(std::size_t body, const Transform<amiss::World, Object>& pose) {
  BodyEntry& entry = impl_->bodies[body];
  impl_->wake_around(entry);
  entry.pose = pose;
  ++entry.revision;
  for (Solid& solid : entry.solids) {
    btRigidBody& rigid = *solid.rigid;
    rigid.setWorldTransform(internal::to_bullet(pose.T * solid.T_body_solid));
    rigid.setInterpolationWorldTransform(rigid.getWorldTransform());
    rigid.setLinearVelocity({0, 0, 0});
    rigid.setAngularVelocity({0, 0, 0});
    rigid.clearForces();
    impl_->bullet.updateSingleAabb(&rigid);
    rigid.activate(true);
  }
  impl_->wake_around(entry);
}

void Physics::step(Duration dt) {
  if (all_asleep()) return;
  const int steps = std::max(1, static_cast<int>(std::ceil(seconds(dt) / impl_->params.step_s - 1e-9)));
  for (int i = 0; i < steps; ++i) impl_->substep(seconds(dt) / steps);
  impl_->read_poses(seconds(dt));
}

std::size_t Physics::body_count() const { return impl_->bodies.size(); }
bool Physics::is_present(std::size_t body) const { return impl_->bodies[body].is_present; }
bool Physics::is_static(std::size_t body) const { return impl_->bodies[body].is_static; }
const std::string& Physics::name(std::size_t body) const { return impl_->bodies[body].name; }

bool Physics::is_asleep(std::size_t body) const {
  const BodyEntry& entry = impl_->bodies[body];
  return entry.is_static || entry.solids.empty() || !entry.solids[0].rigid->isActive();
}

bool Physics::all_asleep() const {
  return std::all_of(impl_->movable.begin(), impl_->movable.end(), [this](std::size_t i) { return is_asleep(i); });
}

const Transform<amiss::World, Object>& Physics::pose(std::size_t body) const { return impl_->bodies[body].pose; }
std::uint64_t Physics::revision(std::size_t body) const { return impl_->bodies[body].revision; }

Eigen::AlignedBox3d Physics::bounds(std::size_t body) const {
  Eigen::AlignedBox3d box;
  for (const Solid& solid : impl_->bodies[body].solids) box.extend(internal::bounds_of(solid));
  return box;
}

std::optional<double> Physics::distance_to_others(std::size_t body, double limit_m) const {
  std::optional<double> least;
  for (const Solid& solid : impl_->bodies[body].solids) {
    impl_->visit_near(
        *solid.rigid, limit_m,
        [&](const BodyEntry& other, const Solid& its) { return &other != &impl_->bodies[body] && !its.is_ground; },
        [&](const Nearest& near) {
          if (!is_standing(near) && near.distance_m <= least.value_or(limit_m)) least = near.distance_m;
        });
  }
  return least;
}

std::optional<Physics::RayHit> Physics::cast_ray(const Point<amiss::World>& from, const Point<amiss::World>& to) const {
  btCollisionWorld::ClosestRayResultCallback hit(internal::to_bullet(from.p), internal::to_bullet(to.p));
  impl_->bullet.rayTest(hit.m_rayFromWorld, hit.m_rayToWorld, hit);
  if (!hit.hasHit() || hit.m_collisionObject->getUserIndex() < 0) return std::nullopt;
  const double range_m = (internal::from_bullet(hit.m_hitPointWorld) - from.p).norm();
  return RayHit{range_m, static_cast<std::size_t>(hit.m_collisionObject->getUserIndex())};
}

}  // namespace amiss::sim
