#include "sim/scripted_robot.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/params.hpp"
#include "core/result.hpp"
#include "world/bounds.hpp"

namespace amiss::sim {

namespace {

using world::Moment;

constexpr double kPeriod_s = 0.02;
constexpr double kRoomForRobot_m = 0.75;  // a walker waits where the robot is nearer than this
const std::string kPerson = "person";

std::string name_of(const world::Change& change) {
  if (const auto* move = std::get_if<world::MoveBody>(&change)) return move->name;
  if (const auto* remove = std::get_if<world::RemoveBody>(&change)) return remove->name;
  if (const auto* close = std::get_if<world::CloseDoor>(&change)) return close->leaf;
  return "";
}

Pose2<amiss::World, Object> heading_from(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return {from.x(), from.y(), std::atan2(to.y() - from.y(), to.x() - from.x())};
}

}  // namespace

Transform<amiss::World, Object> pose_at(const world::Body& body, const world::Place& place) {
  Transform<amiss::World, Object> pose;
  pose.T.linear() = Eigen::AngleAxisd(place.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto& shapes = body.collisions.empty() ? body.visuals : body.collisions;
  const double on_floor_m = shapes.empty() ? 0.0 : -world::bounds(shapes).min().z();
  pose.T.translation() = Eigen::Vector3d(place.x_m, place.y_m, place.z_m.value_or(on_floor_m));
  return pose;
}

std::vector<world::Body> unfix(world::World& world, const world::Script& script) {
  std::set<std::string> added;
  std::vector<std::string> names;
  for (const world::Body& body : world.bodies) names.push_back(body.name);
  for (const world::Event& event : script.events) {
    if (const auto* add = std::get_if<world::AddBody>(&event.change)) added.insert(add->name);
  }
  std::vector<world::Body> taken;
  for (const world::Event& event : script.events) {
    const std::string name = name_of(event.change);
    const bool known = std::any_of(taken.begin(), taken.end(), [&](const world::Body& b) { return b.name == name; });
    if (name.empty() || known || added.contains(name)) continue;
    const auto found =
        std::find_if(world.bodies.begin(), world.bodies.end(), [&](const world::Body& b) { return b.name == name; });
    if (found == world.bodies.end()) {
      const std::string near = nearest_word(name, names);
      throw ArgumentError("there is no '" + name + "' in the world" +
                          (near.empty() ? "" : "; did you mean '" + near + "'?"));
    }
    taken.push_back(std::move(*found));
    world.bodies.erase(found);
  }
  return taken;
}

ScriptedRobot::ScriptedRobot(Simulator& simulator, world::Script script, std::map<std::string, world::Body> bodies,
                             std::uint64_t seed)
    : simulator_(simulator), bodies_(std::move(bodies)), faults_(seed) {
  for (world::Event& event : script.events) {
    Pending pending{std::move(event), std::nullopt, false};
    if (pending.event.moment.kind == Moment::Kind::kTime)
      pending.due = Stamp{} + duration_of(pending.event.moment.after_s);
    pending_.push_back(std::move(pending));
  }
  carry_out_what_is_due();
}

robot::Observation ScriptedRobot::observe() {
  const Eigen::Vector2d robot_m = simulator_.truth().T_world_base.position();
  for (Pending& p : pending_) {
    const Moment& moment = p.event.moment;
    if (moment.kind != Moment::Kind::kRobotNear || p.due || (robot_m - moment.place_m).norm() > moment.within_m)
      continue;
    p.due = now_ + duration_of(moment.after_s);
  }
  carry_out_what_is_due();
  let_walk();
  robot::Observation seen = simulator_.observe();
  now_ = seen.stamp;
  faults_.apply(seen);
  return seen;
}

void ScriptedRobot::come(Moment::Kind kind, const std::string& object) {
  for (Pending& p : pending_) {
    const Moment& moment = p.event.moment;
    if (moment.kind == kind && moment.object == object && !p.due) p.due = now_ + duration_of(moment.after_s);
  }
}

void ScriptedRobot::carry_out_what_is_due() {
  for (Pending& p : pending_) {
    if (p.done || !p.due || *p.due > now_) continue;
    p.done = true;
    carry_out(p.event.change);
    happened_.push_back({now_, to_string(p.event.change)});
  }
}

void ScriptedRobot::carry_out(const world::Change& change) {
  if (const auto* add = std::get_if<world::AddBody>(&change)) put(add->name, body_of(add->kind), add->place);
  if (const auto* move = std::get_if<world::MoveBody>(&change)) {
    simulator_.move_object(move->name, pose_at(body_named(move->name), move->place));
  }
  if (const auto* remove = std::get_if<world::RemoveBody>(&change)) simulator_.remove_object(remove->name);
  if (const auto* close = std::get_if<world::CloseDoor>(&change)) {
    simulator_.move_object(close->leaf, body_named(close->frame).pose);
  }
  if (const auto* walk = std::get_if<world::Walk>(&change)) begin_walk(*walk);
  if (const auto* kidnap = std::get_if<world::Kidnap>(&change)) simulator_.carry_robot(kidnap->T_world_base);
  if (const auto* fault = std::get_if<world::Fault>(&change)) faults_.begin(*fault, now_);
}

void ScriptedRobot::put(const std::string& name, const world::Body& body, const world::Place& place) {
  world::Body added = body;
  added.name = name;
  simulator_.add_object(added, pose_at(body, place), body.name.empty() ? name : body.name);
}

void ScriptedRobot::begin_walk(const world::Walk& walk) {
  const Pose2<amiss::World, Object> at = heading_from(walk.way_m[0], walk.way_m[1]);
  put(walk.name, body_of(kPerson), {at.x_m, at.y_m, {}, at.yaw_rad});
  walkers_.push_back({walk, 1, at});
}

void ScriptedRobot::let_walk() {
  std::erase_if(walkers_, [this](Walker& walker) {
    if (!step(walker)) return false;
    simulator_.remove_object(walker.walk.name);
    return true;
  });
}

bool ScriptedRobot::step(Walker& walker) {
  const Eigen::Vector2d goal = walker.walk.way_m[walker.next];
  const Eigen::Vector2d left = goal - walker.at.position();
  const double step_m = std::min(left.norm(), walker.walk.speed_m_s * kPeriod_s);
  Eigen::Vector2d next = goal;
  if (left.norm() > step_m) next = walker.at.position() + step_m * left.normalized();
  const Eigen::Vector2d robot_m = simulator_.truth().T_world_base.position();
  const double now_m = (walker.at.position() - robot_m).norm(), then_m = (next - robot_m).norm();
  if (then_m < kRoomForRobot_m && then_m < now_m) return false;
  if (next == goal && ++walker.next == walker.walk.way_m.size()) return true;
  const double yaw_rad = left.norm() > 0.0 ? std::atan2(left.y(), left.x()) : walker.at.yaw_rad;
  walker.at = {next.x(), next.y(), yaw_rad};
  simulator_.move_object(walker.walk.name, pose_at(body_of(kPerson), {next.x(), next.y(), {}, yaw_rad}));
  return false;
}

const world::Body& ScriptedRobot::body_of(const std::string& kind) const {
  const auto found = bodies_.find(kind);
  if (found == bodies_.end()) throw ArgumentError("there is no body of the kind '" + kind + "'");
  return found->second;
}

world::Body ScriptedRobot::body_named(const std::string& name) const {
  for (world::Body& body : simulator_.world_now().bodies) {
    if (body.name == name) return body;
  }
  throw ArgumentError("there is no '" + name + "' in the world");
}

std::vector<std::string> ScriptedRobot::not_happened() const {
  std::vector<std::string> texts;
  for (const Pending& p : pending_) {
    if (!p.done) texts.push_back(to_string(p.event.change));
  }
  return texts;
}

}  // namespace amiss::sim
