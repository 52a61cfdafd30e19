#include "sim/robot_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sim/internal/bullet_world.hpp"
#include "world/mesh_file.hpp"

namespace amiss::sim {
namespace {

constexpr double kLift_m = 0.01;       // the robot rolls over what is lower
constexpr double kLookAhead_m = 0.15;  // distances are measured up to here; until so much is driven nothing can be met
constexpr double kAir_m = 0.001;       // between the robot and what holds it
constexpr int kRobotGroup = btBroadphaseProxy::KinematicFilter;
constexpr int kRobotIndex = -2;

world::Geometry geometry_of(const robot::LinkShape& shape, const world::Mesh& mesh) {
  const Eigen::Vector3d& d = shape.dimensions;
  switch (shape.kind) {
    case robot::LinkShape::Kind::kBox:
      return world::Box{d};
    case robot::LinkShape::Kind::kCylinder:
      return world::Cylinder{d.x(), d.y()};
    case robot::LinkShape::Kind::kSphere:
      return world::Sphere{d.x()};
    case robot::LinkShape::Kind::kMesh:
      break;
  }
  return world::MeshInstance{std::make_shared<world::Mesh>(mesh), d};
}

/// The vertices of all parts of a mesh file, for a hull.
world::Mesh vertices_of(const robot::LinkShape& shape) {
  world::Mesh all;
  if (shape.kind != robot::LinkShape::Kind::kMesh) return all;
  for (const world::MeshPart& part : world::load_mesh(shape.mesh).parts) {
    all.vertices.insert(all.vertices.end(), part.mesh->vertices.begin(), part.mesh->vertices.end());
  }
  return all;
}

/// A link as one kinematic body of Bullet.
struct LinkBody {
  std::string name;
  std::size_t link = 0;
  double reach_m = 0.0;  // of its shapes from the link's origin
  std::vector<std::shared_ptr<btConvexShape>> parts;
  std::unique_ptr<btCompoundShape> compound;
  std::unique_ptr<btRigidBody> rigid;
};

LinkBody make_link(const robot::Link& link, std::size_t index, internal::BulletShapes& shapes) {
  LinkBody body;
  body.name = link.name;
  body.link = index;
  body.compound = std::make_unique<btCompoundShape>();
  for (const robot::LinkShape& shape : link.collisions) {
    std::shared_ptr<btConvexShape> part = shapes.moving(geometry_of(shape, vertices_of(shape)));
    if (!part) continue;
    body.compound->addChildShape(internal::to_bullet(shape.T_link_shape), part.get());
    body.parts.push_back(std::move(part));
  }
  if (body.parts.empty()) return body;
  btVector3 low, high;
  body.compound->getAabb(btTransform::getIdentity(), low, high);
  body.reach_m = internal::from_bullet(high.absolute()).cwiseMax(internal::from_bullet(low.absolute())).norm();
  body.rigid = std::make_unique<btRigidBody>(
      btRigidBody::btRigidBodyConstructionInfo(0.0, nullptr, body.compound.get(), btVector3(0, 0, 0)));
  body.rigid->setCollisionFlags(body.rigid->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  body.rigid->setActivationState(DISABLE_DEACTIVATION);
  body.rigid->setFriction(0.5);
  body.rigid->setUserIndex(kRobotIndex);
  body.rigid->setUserIndex2(static_cast<int>(index));
  return body;
}

Eigen::Isometry3d lifted(const Pose2<amiss::World, Base>& pose) {
  return Eigen::Translation3d(0, 0, kLift_m) * pose.lift().T;
}

/// The touched one of a near pair, and which link touches it.
struct Near {
  Nearest nearest;
  std::string link;
};

}  // namespace

struct RobotBody::Impl {
  Physics::Impl& physics;
  std::vector<LinkBody> links;
  RobotState state;
  double clear_m = 0.0;  // so far every point of the robot can still move before it can meet a static body

  std::vector<btTransform> transforms_at(const RobotState& s) const;
  double motion_bound_m(const RobotState& to) const;
  std::optional<Near> nearest_static(const RobotState& at);
  bool stays_clear(const RobotState& wanted, double was_m);
  RobotState allowed(const RobotState& wanted, std::vector<Near>& held);
  bool near_moving();
  void push(const RobotState& from, const RobotState& to, Duration dt, std::map<std::string, Touch>& touches);
  void collect(std::map<std::string, Touch>& touches);
};

std::vector<btTransform> RobotBody::Impl::transforms_at(const RobotState& s) const {
  const Eigen::Isometry3d T_world_base = lifted(s.T_world_base);
  std::vector<btTransform> out;
  for (const LinkBody& link : links) out.push_back(internal::to_bullet(T_world_base * s.T_base_link[link.link]));
  return out;
}

/// No point of the robot moves farther than this between the two states.
double RobotBody::Impl::motion_bound_m(const RobotState& to) const {
  const double travel_m = (to.T_world_base.position() - state.T_world_base.position()).norm();
  const double turn_rad = std::abs(wrap_angle(to.T_world_base.yaw_rad - state.T_world_base.yaw_rad));
  double bound_m = 0.0;
  for (const LinkBody& link : links) {
    const Eigen::Isometry3d& a = state.T_base_link[link.link];
    const Eigen::Isometry3d& b = to.T_base_link[link.link];
    double own_m = turn_rad * (b.translation().head<2>().norm() + link.reach_m);
    if (a.matrix() != b.matrix()) {
      const double angle_rad = Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
      own_m += (a.translation() - b.translation()).norm() + angle_rad * link.reach_m;
    }
    bound_m = std::max(bound_m, own_m);
  }
  return travel_m + bound_m;
}

std::optional<Near> RobotBody::Impl::nearest_static(const RobotState& at) {
  const std::vector<btTransform> transforms = transforms_at(at);
  std::optional<Near> least;
  for (std::size_t i = 0; i < links.size(); ++i) {
    btRigidBody& rigid = *links[i].rigid;
    rigid.setWorldTransform(transforms[i]);
    physics.visit_near(
        rigid, kLookAhead_m,
        [](const BodyEntry& body, const Solid& solid) { return body.is_static && !solid.is_ground; },
        [&](const Nearest& near) {
          if (is_standing(near) || (least && near.distance_m >= least->nearest.distance_m)) return;
          least = Near{near, links[i].name};
        });
  }
  return least;
}

/// Nothing static is touched, or what is touched is not pressed further.
bool RobotBody::Impl::stays_clear(const RobotState& wanted, double was_m) {
  const std::optional<Near> near = nearest_static(wanted);
  return !near || near->nearest.distance_m >= std::min(kAir_m, was_m - 1e-7);
}

/// The wanted state, or the first of some lesser motions that no static body holds up.
RobotState RobotBody::Impl::allowed(const RobotState& wanted, std::vector<Near>& held) {
  const double bound_m = motion_bound_m(wanted);
  if (bound_m < clear_m) {
    clear_m -= bound_m;
    return wanted;
  }
  RobotState stay = wanted;
  stay.T_world_base = state.T_world_base;
  const std::optional<Near> near = nearest_static(wanted);
  const double distance_m = near ? near->nearest.distance_m : kLookAhead_m;
  clear_m = std::max(0.0, distance_m - kAir_m);
  if (distance_m >= kAir_m) return wanted;
  const std::optional<Near> before = nearest_static(stay);
  const double was_m = before ? before->nearest.distance_m : kLookAhead_m;
  if (distance_m >= was_m - 1e-7) return wanted;
  held.push_back(*near);

  const Eigen::Vector2d step = wanted.T_world_base.position() - state.T_world_base.position();
  const Eigen::Vector2d normal = near->nearest.normal.head<2>();
  const Eigen::Vector2d along =
      normal.norm() > 0.1 ? Eigen::Vector2d(step - normal * step.dot(normal) / normal.squaredNorm()) : step;
  std::array<RobotState, 3> lesser{stay, stay, stay};
  lesser[0].T_world_base.x_m += along.x();
  lesser[0].T_world_base.y_m += along.y();
  lesser[1] = lesser[0];
  lesser[0].T_world_base.yaw_rad = lesser[2].T_world_base.yaw_rad = wanted.T_world_base.yaw_rad;
  for (const RobotState& candidate : lesser) {
    if (stays_clear(candidate, was_m)) return candidate;
  }
  return stay;
}

bool RobotBody::Impl::near_moving() {
  for (LinkBody& link : links) {
    btVector3 low, high;
    link.compound->getAabb(link.rigid->getWorldTransform(), low, high);
    const Eigen::AlignedBox3d box(internal::from_bullet(low).array() - 0.05,
                                  internal::from_bullet(high).array() + 0.05);
    for (const std::size_t index : physics.movable) {
      physics.bodies[index].solids[0].rigid->getAabb(low, high);
      if (box.intersects(Eigen::AlignedBox3d(internal::from_bullet(low), internal::from_bullet(high)))) return true;
    }
  }
  return false;
}

/// Steps the world while the links go from one state to the other at constant speed.
void RobotBody::Impl::push(const RobotState& from, const RobotState& to, Duration dt,
                           std::map<std::string, Touch>& touches) {
  const int steps = std::max(1, static_cast<int>(std::ceil(seconds(dt) / physics.params.step_s - 1e-9)));
  RobotState at = to;
  const double turn_rad = wrap_angle(to.T_world_base.yaw_rad - from.T_world_base.yaw_rad);
  std::vector<btTransform> last = transforms_at(from);
  for (int step = 1; step <= steps; ++step) {
    const double part = static_cast<double>(step) / steps;
    at.T_world_base.x_m = std::lerp(from.T_world_base.x_m, to.T_world_base.x_m, part);
    at.T_world_base.y_m = std::lerp(from.T_world_base.y_m, to.T_world_base.y_m, part);
    at.T_world_base.yaw_rad = from.T_world_base.yaw_rad + part * turn_rad;
    const std::vector<btTransform> next = transforms_at(at);
    for (std::size_t i = 0; i < links.size(); ++i) {
      links[i].rigid->setInterpolationWorldTransform(last[i]);  // Bullet takes the velocity from the difference
      links[i].rigid->setWorldTransform(next[i]);
    }
    last = next;
    physics.substep(seconds(dt) / steps);
    collect(touches);
  }
  physics.read_poses(seconds(dt));
}

void RobotBody::Impl::collect(std::map<std::string, Touch>& touches) {
  for (int i = 0; i < physics.dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = physics.dispatcher.getManifoldByIndexInternal(i);
    const btCollisionObject* robot = manifold->getBody0();
    const btCollisionObject* other = manifold->getBody1();
    if (other->getUserIndex() == kRobotIndex) std::swap(robot, other);
    if (robot->getUserIndex() != kRobotIndex || other->getUserIndex() < 0) continue;
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      if (manifold->getContactPoint(k).getDistance() > 0.0) continue;
      const BodyEntry& body = *physics.entry_of(other);
      const auto link =
          std::find_if(links.begin(), links.end(), [&](const LinkBody& l) { return l.rigid.get() == robot; });
      const Point<amiss::World> at{internal::from_bullet(manifold->getContactPoint(k).getPositionWorldOnB())};
      touches.try_emplace(body.name, Touch{link->name, body.name, at});
      break;
    }
  }
}

RobotBody::RobotBody(Physics& physics, const robot::Model& model, const RobotState& start)
    : impl_(std::make_unique<Impl>(Impl{physics.impl(), {}, start, 0.0})) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    LinkBody link = make_link(model.links[i], i, impl_->physics.shapes);
    if (link.rigid) impl_->links.push_back(std::move(link));
  }
  const std::vector<btTransform> transforms = impl_->transforms_at(start);
  for (std::size_t i = 0; i < impl_->links.size(); ++i) {
    impl_->links[i].rigid->setWorldTransform(transforms[i]);
    impl_->physics.bullet.addRigidBody(impl_->links[i].rigid.get(), kRobotGroup, btBroadphaseProxy::DefaultFilter);
  }
}

RobotBody::~RobotBody() {
  if (!impl_) return;
  for (const LinkBody& link : impl_->links) impl_->physics.bullet.removeRigidBody(link.rigid.get());
}

RobotBody::RobotBody(RobotBody&&) noexcept = default;

RobotStep RobotBody::move(const RobotState& wanted, Duration dt) {
  std::vector<Near> held;
  const RobotState before = impl_->state;
  const RobotState reached = impl_->allowed(wanted, held);
  RobotStep step;
  step.blocked = !held.empty();
  std::map<std::string, Touch> touches;
  for (const Near& near : held) {
    const std::string& body = impl_->physics.bodies[near.nearest.body].name;
    touches.try_emplace(body, Touch{near.link, body, {near.nearest.position}});
  }
  const bool anything_awake =
      std::any_of(impl_->physics.movable.begin(), impl_->physics.movable.end(),
                  [&](auto index) { return impl_->physics.bodies[index].solids[0].rigid->isActive(); });
  const std::vector<btTransform> transforms = impl_->transforms_at(reached);
  for (std::size_t i = 0; i < impl_->links.size(); ++i) impl_->links[i].rigid->setWorldTransform(transforms[i]);
  if (anything_awake || impl_->near_moving()) impl_->push(before, reached, dt, touches);
  impl_->state = reached;
  step.T_world_base = reached.T_world_base;
  for (auto& [body, touch] : touches) step.touches.push_back(std::move(touch));
  return step;
}

void RobotBody::put(const RobotState& state) { impl_->state = state; }
void RobotBody::statics_changed() { impl_->clear_m = 0.0; }

bool RobotBody::fits(const RobotState& state) {
  const std::optional<Near> near = impl_->nearest_static(state);
  return !near || near->nearest.distance_m >= kAir_m;
}

}  // namespace amiss::sim
