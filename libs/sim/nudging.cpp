#include "sim/nudging.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/physics.hpp"
#include "sim/supports.hpp"
#include "world/bounds.hpp"

namespace amiss::sim {
namespace {

constexpr double kStandsOnFloor_m = 0.03;  // no higher above it
constexpr double kNear_m = 0.01;           // distances beyond this are all alike
constexpr double kAllowed_m = 0.002;       // that two bodies may come to overlap

bool is_built_in(SemanticClass value) {
  switch (value) {
    case SemanticClass::kUnlabelled:
    case SemanticClass::kWall:
    case SemanticClass::kFloor:
    case SemanticClass::kDoor:
    case SemanticClass::kWindow:
    case SemanticClass::kPicture:
    case SemanticClass::kCounter:
    case SemanticClass::kCurtain:
    case SemanticClass::kShowerCurtain:
    case SemanticClass::kRefrigerator:
    case SemanticClass::kToilet:
    case SemanticClass::kSink:
    case SemanticClass::kBathtub:
      return true;
    case SemanticClass::kCabinet:
    case SemanticClass::kBed:
    case SemanticClass::kChair:
    case SemanticClass::kSofa:
    case SemanticClass::kTable:
    case SemanticClass::kBookshelf:
    case SemanticClass::kDesk:
    case SemanticClass::kOtherFurniture:
    case SemanticClass::kOtherProp:
      return false;
  }
  return true;
}

/// A body that can be nudged.
struct Loose {
  std::size_t body;
  std::optional<std::size_t> carrier;  // index of a body; none: the floor
  double foot_z_m;
};

std::vector<Loose> find_loose(const world::World& world, const world::ClassTable& classes) {
  const std::vector<Support> supports = find_supports(world, {0.1, 2.0, 0.15});
  std::vector<Loose> loose;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const world::Body& body = world.bodies[i];
    const Eigen::AlignedBox3d box = world::bounds_in_world(body);
    if (!body.is_static || body.collisions.empty() || is_built_in(classes.class_of(body.name))) continue;
    const std::optional<Support> under = support_under(supports, foot_of(box), i);
    if (!under && std::abs(box.min().z()) > kStandsOnFloor_m) continue;
    loose.push_back({i, under ? std::optional(under->body) : std::nullopt, box.min().z()});
  }
  std::stable_sort(loose.begin(), loose.end(), [](const Loose& a, const Loose& b) { return a.foot_z_m < b.foot_z_m; });
  return loose;
}

class Nudging {
 public:
  Nudging(const world::World& world, std::vector<Loose> loose)
      : loose_(std::move(loose)), physics_(as_movable(world, loose_)) {}

  /// Moves the body and what stands on it, unless this pushes them into something.
  void nudge(const Loose& loose, const world::Nudge& by) {
    const Eigen::Isometry3d T =
        world::nudged(physics_.pose(loose.body), by).T * physics_.pose(loose.body).T.inverse();
    const std::vector<std::size_t> group = carried_by(loose.body);
    const double before_m = least_gap_m(group);
    move(group, T);
    if (least_gap_m(group) < std::min(0.0, before_m) - kAllowed_m) move(group, T.inverse());
  }
  [[nodiscard]] const Transform<amiss::World, Object>& pose(std::size_t body) const { return physics_.pose(body); }
  [[nodiscard]] const std::vector<Loose>& loose() const { return loose_; }

 private:
  static world::World as_movable(world::World world, const std::vector<Loose>& loose) {
    for (const Loose& one : loose) world.bodies[one.body].is_static = false;
    return world;
  }
  /// The body itself and all that stands on it, directly or not; carriers come first in loose_.
  [[nodiscard]] std::vector<std::size_t> carried_by(std::size_t body) const {
    std::vector<std::size_t> group{body};
    for (const Loose& one : loose_) {
      if (one.carrier && std::find(group.begin(), group.end(), *one.carrier) != group.end()) group.push_back(one.body);
    }
    return group;
  }
  [[nodiscard]] double least_gap_m(const std::vector<std::size_t>& group) const {
    double least_m = kNear_m;
    for (const std::size_t body : group) {
      least_m = std::min(least_m, physics_.distance_to_others(body, kNear_m).value_or(kNear_m));
    }
    return least_m;
  }
  void move(const std::vector<std::size_t>& group, const Eigen::Isometry3d& T) {
    for (const std::size_t body : group) physics_.place(body, {T * physics_.pose(body).T});
  }

  std::vector<Loose> loose_;
  Physics physics_;
};

/// The nudge that leads from one pose to the other.
world::Nudge nudge_between(const world::Body& body, const Transform<amiss::World, Object>& after) {
  const Eigen::Matrix3d R = after.T.linear() * body.pose.T.linear().transpose();
  return {body.name, (after.position() - body.pose.position()).head<2>(), std::atan2(R(1, 0), R(0, 0))};
}

}  // namespace

void describe(ParamTable& table, NudgingParams& params) {
  table.number("nudging.part", params.part, "", 0.0, 1.0, "of furniture and permanent things that are nudged");
  table.number("nudging.furniture_shift", params.furniture_shift_m, "m", 0.0, 0.2, "of what stands on the floor");
  table.number("nudging.furniture_yaw", params.furniture_yaw_rad, "deg", 0.0, 45.0, "of what stands on the floor");
  table.number("nudging.thing_shift", params.thing_shift_m, "m", 0.0, 0.2, "of what stands on furniture");
  table.number("nudging.thing_yaw", params.thing_yaw_rad, "deg", 0.0, 180.0, "of what stands on furniture");
}

std::vector<world::Nudge> random_nudges(const world::World& world, const world::ClassTable& classes,
                                        const NudgingParams& params, RandomStream& random) {
  Nudging nudging(world, find_loose(world, classes));
  for (const Loose& loose : nudging.loose()) {
    if (random.uniform() >= params.part) continue;
    const double shift_m = loose.carrier ? params.thing_shift_m : params.furniture_shift_m;
    const double yaw_rad = loose.carrier ? params.thing_yaw_rad : params.furniture_yaw_rad;
    world::Nudge by;
    by.shift_m.x() = random.uniform(-shift_m, shift_m);
    by.shift_m.y() = random.uniform(-shift_m, shift_m);
    by.yaw_rad = random.uniform(-yaw_rad, yaw_rad);
    nudging.nudge(loose, by);
  }
  std::vector<world::Nudge> nudges;
  for (const Loose& loose : nudging.loose()) {
    const world::Nudge nudge = nudge_between(world.bodies[loose.body], nudging.pose(loose.body));
    if (nudge.shift_m.norm() > 1e-9 || std::abs(nudge.yaw_rad) > 1e-9) nudges.push_back(nudge);
  }
  return nudges;
}

}  // namespace amiss::sim
