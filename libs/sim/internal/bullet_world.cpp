#include "sim/internal/bullet_world.hpp"

namespace amiss::sim {
namespace {

constexpr int kStaticGroup = btBroadphaseProxy::StaticFilter;
constexpr int kMovingGroup = btBroadphaseProxy::DefaultFilter;
constexpr double kSleepSpeed_m_s = 0.05, kSleepRate_rad_s = 0.5;

// What stays so near to one place for so long is at rest, whatever its speed.
constexpr double kStill_m = 0.005, kStill_rad = 0.05, kStillFor_s = 2.0;

constexpr double kWedged_m = 0.003;

/// Bullet's callback for closest points, forwarded with the probe first.
struct NearCallback : btCollisionWorld::ContactResultCallback {
  NearCallback(const btCollisionObject& probe, double limit_m) : probe_(probe) { m_closestDistanceThreshold = limit_m; }

  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* first, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    const bool probe_is_first = first->getCollisionObject() == &probe_;
    const btVector3& at = probe_is_first ? point.getPositionWorldOnB() : point.getPositionWorldOnA();
    const Eigen::Vector3d normal = internal::from_bullet(point.m_normalWorldOnB);
    found.push_back(
        {point.getDistance(), 0, internal::from_bullet(at), probe_is_first ? normal : Eigen::Vector3d(-normal)});
    return 0;
  }

  std::vector<Nearest> found;

 private:
  const btCollisionObject& probe_;
};

struct OverlapCallback : btBroadphaseAabbCallback {
  bool process(const btBroadphaseProxy* proxy) override {
    found.push_back(static_cast<btCollisionObject*>(proxy->m_clientObject));
    return true;
  }
  std::vector<btCollisionObject*> found;
};

bool reaches_over_ground(const world::Geometry& geometry, const Eigen::Isometry3d& T, const btRigidBody& rigid) {
  if (const auto* plane = std::get_if<world::Plane>(&geometry)) {
    return (T.linear() * plane->normal.normalized()).z() < 0.99 || T.translation().z() > kGroundTop_m;
  }
  btVector3 low, high;
  rigid.getAabb(low, high);
  return high.z() > kGroundTop_m + 1e-3;
}

btRigidBody::btRigidBodyConstructionInfo material_of(const world::Body& body, const PhysicsParams& params, double mass,
                                                     btCollisionShape& shape) {
  btVector3 inertia(0, 0, 0);
  if (mass > 0.0) shape.calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
  info.m_friction = body.friction;
  info.m_rollingFriction = params.rolling_friction;
  info.m_spinningFriction = params.rolling_friction;
  info.m_linearDamping = params.linear_damping;
  info.m_angularDamping = params.angular_damping;
  info.m_linearSleepingThreshold = kSleepSpeed_m_s;
  info.m_angularSleepingThreshold = kSleepRate_rad_s;
  return info;
}

Solid fixed_solid(const world::Body& body, const world::Shape& shape, internal::BulletShapes& shapes,
                  const PhysicsParams& params) {
  Solid solid;
  std::shared_ptr<btCollisionShape> made = shapes.fixed(shape.geometry);
  if (!made) return solid;
  solid.shapes = {made};
  solid.rigid = std::make_unique<btRigidBody>(material_of(body, params, 0.0, *made));
  solid.T_body_solid = shape.T_body_shape;
  const Eigen::Isometry3d T = body.pose.T * shape.T_body_shape;
  solid.rigid->setWorldTransform(internal::to_bullet(T));
  solid.is_ground = !reaches_over_ground(shape.geometry, T, *solid.rigid);
  return solid;
}

/// All shapes in one compound about their common centre of mass.
Solid moving_solid(const world::Body& body, internal::BulletShapes& shapes, const PhysicsParams& params) {
  Solid solid;
  std::vector<std::pair<Eigen::Isometry3d, std::shared_ptr<btConvexShape>>> parts;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double volume = 0.0;
  for (const world::Shape& shape : body.collisions) {
    std::shared_ptr<btConvexShape> part = shapes.moving(shape.geometry);
    if (!part) continue;
    const internal::Bulk bulk = internal::bulk_of(*part);
    centre += bulk.volume_m3 * (shape.T_body_shape * bulk.centre);
    volume += bulk.volume_m3;
    parts.emplace_back(shape.T_body_shape, std::move(part));
  }
  if (parts.empty()) return solid;
  if (volume > 0.0) solid.T_body_solid.translation() = centre / volume;
  auto compound = std::make_shared<btCompoundShape>();
  double smallest_m = 1.0;
  for (const auto& [T_body_part, part] : parts) {
    compound->addChildShape(internal::to_bullet(solid.T_body_solid.inverse() * T_body_part), part.get());
    btVector3 low, high;
    part->getAabb(btTransform::getIdentity(), low, high);
    smallest_m = std::min(smallest_m, internal::from_bullet(0.5 * (high - low)).minCoeff());
    solid.shapes.push_back(part);
  }
  solid.shapes.push_back(compound);
  solid.rigid = std::make_unique<btRigidBody>(material_of(body, params, std::max(body.mass_kg, 1e-3), *compound));
  solid.rigid->setCcdMotionThreshold(smallest_m);
  solid.rigid->setCcdSweptSphereRadius(0.5 * smallest_m);
  return solid;
}

void extend_by(Eigen::AlignedBox3d& box, const btConvexShape& shape, const Eigen::Isometry3d& T) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d direction = T.linear().transpose() * (sign * Eigen::Vector3d::Unit(axis));
      const Eigen::Vector3d p = internal::from_bullet(shape.localGetSupportingVertex(internal::to_bullet(direction)));
      box.extend(T * p);
    }
  }
}

}  // namespace

Eigen::AlignedBox3d internal::bounds_of(const Solid& solid) {
  Eigen::AlignedBox3d box;
  const Eigen::Isometry3d T = from_bullet(solid.rigid->getWorldTransform());
  const btCollisionShape* shape = solid.shapes.back().get();
  if (shape->isCompound()) {
    const auto* compound = static_cast<const btCompoundShape*>(shape);
    for (int i = 0; i < compound->getNumChildShapes(); ++i) {
      const auto* part = static_cast<const btConvexShape*>(compound->getChildShape(i));
      extend_by(box, *part, T * from_bullet(compound->getChildTransform(i)));
    }
    return box;
  }
  btVector3 low, high;
  shape->getAabb(to_bullet(T), low, high);
  box.extend(from_bullet(low));
  box.extend(from_bullet(high));
  return box;
}

Physics::Impl::Impl(const PhysicsParams& wanted)
    : params(wanted), dispatcher(&configuration), bullet(&dispatcher, &broadphase, &solver, &configuration) {
  bullet.setGravity({0, 0, -9.81});
  bullet.setForceUpdateAllAabbs(false);
}

Physics::Impl::~Impl() {
  for (BodyEntry& entry : bodies) take_out(entry);
}

void Physics::Impl::add_solids(BodyEntry& entry, const world::Body& body, int index) {
  if (body.is_static) {
    for (const world::Shape& shape : body.collisions) {
      entry.solids.push_back(fixed_solid(body, shape, shapes, params));
    }
  } else {
    entry.solids.push_back(moving_solid(body, shapes, params));
  }
  std::erase_if(entry.solids, [](const Solid& solid) { return !solid.rigid; });
  for (Solid& solid : entry.solids) {
    solid.rigid->setUserIndex(index);
    solid.rigid->setWorldTransform(internal::to_bullet(body.pose.T * solid.T_body_solid));
    solid.rigid->setInterpolationWorldTransform(solid.rigid->getWorldTransform());
    if (body.is_static) {
      bullet.addRigidBody(solid.rigid.get(), kStaticGroup, btBroadphaseProxy::AllFilter ^ kStaticGroup);
    } else {
      bullet.addRigidBody(solid.rigid.get(), kMovingGroup, btBroadphaseProxy::AllFilter);
    }
  }
}

void Physics::Impl::take_out(BodyEntry& entry) {
  for (Solid& solid : entry.solids) bullet.removeRigidBody(solid.rigid.get());
  entry.solids.clear();
}

void Physics::Impl::wake_around(const BodyEntry& entry) {
  for (const Solid& solid : entry.solids) {
    btVector3 low, high;
    solid.rigid->getAabb(low, high);
    const btVector3 margin(0.02, 0.02, 0.02);
    OverlapCallback overlap;
    broadphase.aabbTest(low - margin, high + margin, overlap);
    for (btCollisionObject* object : overlap.found) {
      if (!object->isStaticOrKinematicObject()) object->activate(true);
    }
  }
}

void Physics::Impl::substep(double dt_s) { bullet.stepSimulation(dt_s, 0); }

void Physics::Impl::read_poses(double elapsed_s) {
  for (const std::size_t index : movable) {
    BodyEntry& entry = bodies[index];
    if (!entry.solids[0].rigid->isActive()) {
      entry.still_s = 0.0;
      continue;
    }
    const Solid& solid = entry.solids[0];
    const Eigen::Isometry3d T = internal::from_bullet(solid.rigid->getWorldTransform()) * solid.T_body_solid.inverse();
    if (T.matrix() != entry.pose.T.matrix()) {
      entry.pose.T = T;
      ++entry.revision;
    }
    still_to_sleep(entry, elapsed_s);
  }
}

/// A drawer that trembles in its frame would never rest by Bullet's own measure, the speed.
void Physics::Impl::still_to_sleep(BodyEntry& entry, double elapsed_s) {
  const double turned_rad = Eigen::AngleAxisd(entry.still_at.linear().transpose() * entry.pose.T.linear()).angle();
  const double moved_m = (entry.still_at.translation() - entry.pose.T.translation()).norm();
  entry.still_s += elapsed_s;
  if (moved_m > kStill_m || turned_rad > kStill_rad) {
    entry.still_at = entry.pose.T;
    entry.still_s = 0.0;
  }
  if (entry.still_s < kStillFor_s) return;
  btRigidBody& rigid = *entry.solids[0].rigid;
  rigid.setLinearVelocity({0, 0, 0});
  rigid.setAngularVelocity({0, 0, 0});
  rigid.forceActivationState(ISLAND_SLEEPING);
  entry.still_s = 0.0;
}

void Physics::Impl::rest_what_is_wedged() {
  for (const std::size_t index : movable) {
    btRigidBody& rigid = *bodies[index].solids[0].rigid;
    bool is_wedged = false;
    visit_near(
        rigid, 0.0, [](const BodyEntry& other, const Solid& solid) { return other.is_static && !solid.is_ground; },
        [&](const Nearest& near) { is_wedged = is_wedged || near.distance_m < -kWedged_m; });
    if (is_wedged) rigid.forceActivationState(ISLAND_SLEEPING);
  }
}

void Physics::Impl::visit_near(btCollisionObject& probe, double limit_m, const Accept& accept,
                               const std::function<void(const Nearest&)>& visit) {
  btVector3 low, high;
  probe.getCollisionShape()->getAabb(probe.getWorldTransform(), low, high);
  const btVector3 margin(limit_m, limit_m, limit_m);
  OverlapCallback overlap;
  broadphase.aabbTest(low - margin, high + margin, overlap);
  for (btCollisionObject* object : overlap.found) {
    BodyEntry* entry = object == &probe ? nullptr : entry_of(object);
    if (entry == nullptr) continue;
    const auto solid = std::find_if(entry->solids.begin(), entry->solids.end(),
                                    [&](const Solid& s) { return s.rigid.get() == object; });
    if (solid == entry->solids.end() || !accept(*entry, *solid)) continue;
    NearCallback callback(probe, limit_m);
    bullet.contactPairTest(&probe, object, callback);
    for (Nearest& near : callback.found) {
      near.body = static_cast<std::size_t>(object->getUserIndex());
      visit(near);
    }
  }
}

BodyEntry* Physics::Impl::entry_of(const btCollisionObject* object) {
  const int index = object->getUserIndex();
  return index < 0 ? nullptr : &bodies[static_cast<std::size_t>(index)];
}

}  // namespace amiss::sim
