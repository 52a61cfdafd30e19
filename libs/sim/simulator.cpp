#include "sim/simulator.hpp"

#include "core/result.hpp"
#include "sim/collision_log.hpp"
#include "sim/internal/cpu_meter.hpp"
#include "sim/internal/frame_source.hpp"
#include "sim/motors.hpp"
#include "sim/robot_body.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;

constexpr Duration kControlPeriod = 20ms;
constexpr std::uint64_t kNeverCut = ~std::uint64_t{0};

Duration checked_period(double period_s, const std::string& key) {
  const Duration period = duration_of(period_s);
  if (period >= kControlPeriod) return period;
  throw ArgumentError(key + ": at least the control period of 0.02 s is allowed");
}

std::vector<Eigen::Isometry3d> link_poses(const robot::Model& model, const robot::HeadState& head) {
  return model.link_poses({{model.pan_joint, head.pan_rad}, {model.tilt_joint, head.tilt_rad}});
}

}  // namespace

void describe(ParamTable& table, SimulatorParams& params) {
  describe(table, params.physics);
  describe(table, params.laser);
  describe(table, params.odometry);
  describe(table, params.depth);
  table.number("camera.period", params.camera_period_s, "s", 0.02, 60.0, "time between two frames");
  table.number("camera.delay", params.camera_delay_s, "s", 0.0, 2.0, "from the instant of a frame to its arrival");
}

struct Simulator::Impl {
  Impl(world::World world_, robot::Model model_, const SimulatorParams& params_, std::uint64_t seed,
       const Pose2<amiss::World, Base>& start, Worker& worker);

  world::World world;
  robot::Model model;
  SimulatorParams params;
  Duration laser_period, camera_period;
  Stamp now{};
  robot::Command wanted;
  Pose2<amiss::World, Base> T_world_base;
  Motors motors;
  std::vector<Eigen::Isometry3d> T_base_link;
  Physics physics;
  RobotBody robot;
  CollisionLog log;
  LaserScanner laser;
  RandomStream laser_noise;
  OdometryModel odometry;
  std::vector<std::string> kinds;              // by body, empty for the world's own
  std::vector<bool> told_of;                   // by body
  std::vector<std::uint64_t> laser_revisions;  // of the cuts that the laser has, by body
  CpuTime cpu;
  internal::FrameSource camera;  // last: its pending jobs end before anything else does

  bool drive();
  LaserScan scan();
  void capture(const Pose2<Odom, Base>& T_odom_base);
  [[nodiscard]] internal::Scene scene(const Transform<amiss::World, Camera>& T_world_camera) const;
  [[nodiscard]] bool is_object(std::size_t body) const;
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const;
  [[nodiscard]] std::size_t object_named(const std::string& name, const std::string& caller) const;
};

Simulator::Impl::Impl(world::World world_, robot::Model model_, const SimulatorParams& params_, std::uint64_t seed,
                      const Pose2<amiss::World, Base>& start, Worker& worker)
    : world(std::move(world_)),
      model(std::move(model_)),
      params(params_),
      laser_period(checked_period(params.laser.period_s, "laser.period")),
      camera_period(checked_period(params.camera_period_s, "camera.period")),
      T_world_base(start),
      motors(model.limits),
      T_base_link(link_poses(model, motors.head())),
      physics(world, params.physics),
      robot(physics, model, {start, T_base_link}),
      laser(world, model.T_base_laser.position().z(), params.laser),
      laser_noise(seed, "laser"),
      odometry(params.odometry, RandomStream(seed, "odometry"), start),
      kinds(world.bodies.size()),
      told_of(world.bodies.size(), false),
      laser_revisions(world.bodies.size(), kNeverCut),
      camera(world, model.camera, params.depth, seed, worker) {}

/// Motors and bodies; true when something held the robot.
bool Simulator::Impl::drive() {
  const internal::CpuMeter meter(cpu.physics_s);
  const robot::HeadState before = motors.head();
  motors.step(wanted, kControlPeriod);
  const robot::HeadState head = motors.head();
  if (head.pan_rad != before.pan_rad || head.tilt_rad != before.tilt_rad) T_base_link = link_poses(model, head);
  const RobotStep step = robot.move({motors.advanced(T_world_base, kControlPeriod), T_base_link}, kControlPeriod);
  if (step.blocked) {
    const Eigen::Rotation2Dd to_base(-T_world_base.yaw_rad);
    const Eigen::Vector2d travel = step.T_world_base.position() - T_world_base.position();
    const double turn_rad = wrap_angle(step.T_world_base.yaw_rad - T_world_base.yaw_rad);
    motors.held(to_base * travel / seconds(kControlPeriod), turn_rad / seconds(kControlPeriod));
  }
  T_world_base = step.T_world_base;
  log.note(now, step.touches);
  return step.blocked;
}

LaserScan Simulator::Impl::scan() {
  const internal::CpuMeter meter(cpu.laser_s);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!is_object(i) || laser_revisions[i] == physics.revision(i)) continue;
    laser_revisions[i] = physics.revision(i);
    if (physics.is_present(i)) {
      laser.set_moving(i, world.bodies[i], physics.pose(i));
    } else {
      laser.remove_moving(i);
    }
  }
  const Eigen::Isometry3d& T = model.T_base_laser.T;
  const Pose2<Base, Laser> T_base_laser{T.translation().x(), T.translation().y(), std::atan2(T(1, 0), T(0, 0))};
  return laser.measure(now, T_world_base * T_base_laser, laser_noise);
}

void Simulator::Impl::capture(const Pose2<Odom, Base>& T_odom_base) {
  const Transform<Base, Camera> T_base_camera = model.T_base_camera(motors.head());
  camera.capture(now, duration_of(params.camera_delay_s), scene(T_world_base.lift() * T_base_camera), T_base_camera,
                 T_odom_base);
}

internal::Scene Simulator::Impl::scene(const Transform<amiss::World, Camera>& T_world_camera) const {
  internal::Scene scene{T_world_camera, {}, {}};
  scene.poses.reserve(world.bodies.size());
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    scene.poses.push_back(physics.pose(i));
    if (!physics.is_present(i)) scene.hidden.push_back(i);
  }
  return scene;
}

bool Simulator::Impl::is_object(std::size_t body) const {
  return !world.bodies[body].is_static || !kinds[body].empty();
}

std::optional<std::size_t> Simulator::Impl::find(const std::string& name) const {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (physics.is_present(i) && world.bodies[i].name == name) return i;
  }
  return std::nullopt;
}

std::size_t Simulator::Impl::object_named(const std::string& name, const std::string& caller) const {
  const std::optional<std::size_t> index = find(name);
  if (index && is_object(*index)) return *index;
  throw ArgumentError(caller + ": '" + name + "' is " + (index ? "part of the building" : "not in the world") +
                      "; movable bodies and added objects are allowed");
}

Simulator::Simulator(world::World world, robot::Model model, const SimulatorParams& params, std::uint64_t seed,
                     const Pose2<amiss::World, Base>& start, Worker& worker)
    : impl_(std::make_unique<Impl>(std::move(world), std::move(model), params, seed, start, worker)) {}
Simulator::~Simulator() = default;

const robot::Model& Simulator::model() const { return impl_->model; }
void Simulator::command(const robot::Command& command) { impl_->wanted = command; }

robot::Observation Simulator::observe() {
  Impl& s = *impl_;
  s.now += kControlPeriod;
  robot::Observation seen;
  seen.stamp = s.now;
  seen.bumper = s.drive();
  seen.head = s.motors.head();
  seen.odometry = s.odometry.update(s.now, s.T_world_base);
  // The first control period at or after each multiple of the sensor's period.
  const auto is_due = [&](Duration period) { return s.now.time_since_epoch() % period < kControlPeriod; };
  if (is_due(s.laser_period)) seen.scan = s.scan();
  if (is_due(s.camera_period)) s.capture(seen.odometry.T_odom_base);
  seen.frame = s.camera.arrival(s.now);
  return seen;
}

world::Truth Simulator::truth() const {
  const Impl& s = *impl_;
  world::Truth truth{s.now, s.T_world_base, {}};
  for (std::size_t i = 0; i < s.world.bodies.size(); ++i) {
    if (!s.physics.is_present(i) || !(s.is_object(i) || s.told_of[i])) continue;
    truth.objects.push_back({s.world.bodies[i].name, s.kinds[i], static_cast<std::uint16_t>(i + 1), s.physics.pose(i),
                             s.physics.bounds(i)});
  }
  return truth;
}

const std::vector<world::Collision>& Simulator::collisions() const { return impl_->log.collisions(); }

const world::InstanceImage* Simulator::instances_of(Stamp stamp) const { return impl_->camera.instances_of(stamp); }

world::World Simulator::world_now() const {
  world::World now = impl_->world;
  now.bodies.clear();
  for (std::size_t i = 0; i < impl_->world.bodies.size(); ++i) {
    if (!impl_->physics.is_present(i)) continue;
    now.bodies.push_back(impl_->world.bodies[i]);
    now.bodies.back().pose = impl_->physics.pose(i);
  }
  return now;
}

RenderedFrame Simulator::picture(const Transform<amiss::World, Camera>& T_world_camera,
                                 const CameraIntrinsics& intrinsics) {
  return impl_->camera.picture(impl_->scene(T_world_camera), intrinsics);
}

std::uint16_t Simulator::add_object(const world::Body& body, const Transform<amiss::World, Object>& pose,
                                    const std::string& kind) {
  Impl& s = *impl_;
  if (kind.empty()) throw ArgumentError("add_object: '" + body.name + "' needs a kind");
  if (s.find(body.name)) {
    throw ArgumentError("add_object: there is a body '" + body.name + "' already; names are unique");
  }
  world::Body& added = s.world.bodies.emplace_back(body);
  added.pose = pose;
  s.kinds.push_back(kind);
  s.told_of.push_back(false);
  s.laser_revisions.push_back(kNeverCut);
  s.physics.add(added);
  s.camera.add_body(added);
  s.robot.statics_changed();
  return static_cast<std::uint16_t>(s.world.bodies.size());
}

void Simulator::move_object(const std::string& name, const Transform<amiss::World, Object>& pose) {
  impl_->physics.place(impl_->object_named(name, "move_object"), pose);
  impl_->robot.statics_changed();
}

void Simulator::remove_object(const std::string& name) {
  impl_->physics.remove(impl_->object_named(name, "remove_object"));
  impl_->robot.statics_changed();
}

void Simulator::carry_robot(const Pose2<amiss::World, Base>& T_world_base) {
  Impl& s = *impl_;
  const RobotState there{T_world_base, s.T_base_link};
  if (!s.robot.fits(there)) {
    throw ArgumentError("carry_robot: something fixed is where the robot would stand; a place with room is allowed");
  }
  s.T_world_base = T_world_base;
  s.robot.put(there);
  s.robot.statics_changed();
  s.odometry.carried_to(T_world_base);
}

void Simulator::tell_of(const std::string& name) {
  const std::optional<std::size_t> index = impl_->find(name);
  if (!index) throw ArgumentError("tell_of: '" + name + "' is not in the world");
  impl_->told_of[*index] = true;
}

Simulator::CpuTime Simulator::cpu_time() const {
  CpuTime cpu = impl_->cpu;
  cpu.render_s = impl_->camera.render_cpu_s();
  cpu.noise_s = impl_->camera.noise_cpu_s();
  return cpu;
}

}  // namespace amiss::sim
