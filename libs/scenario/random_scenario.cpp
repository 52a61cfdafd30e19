#include "scenario/random_scenario.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace amiss::scenario {

namespace {

using world::FaultKind;
using world::Sensor;

constexpr double kTimeLimit_s = 300.0;
constexpr std::uint64_t kTenths = 10;

double tenth(double value) { return std::round(value * 10.0) / 10.0; }
double hundredth(double value) { return std::round(value * 100.0) / 100.0; }

double degrees_by_chance(RandomStream& random) { return radians(std::round(random.uniform(-180.0, 180.0))); }

world::Fault fault_by_chance(RandomStream& random) {
  constexpr std::array kSensors{Sensor::kCamera, Sensor::kLaser, Sensor::kOdometry};
  constexpr std::array kKinds{FaultKind::kOff,  FaultKind::kStuck,   FaultKind::kGarbage,     FaultKind::kWrong,
                              FaultKind::kSlow, FaultKind::kDelayed, FaultKind::kIntermittent};
  world::Fault fault;
  fault.sensor = kSensors[random.below(kSensors.size())];
  fault.kind = kKinds[random.below(kKinds.size())];
  if (random.below(2) == 0) fault.for_s = tenth(random.uniform(1.0, 10.0));
  if (fault.kind == FaultKind::kWrong) fault.amount = hundredth(random.uniform(0.7, 1.4));
  if (fault.kind == FaultKind::kSlow || fault.kind == FaultKind::kIntermittent) {
    fault.amount = tenth(random.uniform(0.3, 2.0));
  }
  if (fault.kind == FaultKind::kDelayed) fault.amount = tenth(random.uniform(0.1, 1.0));
  return fault;
}

world::Fault jump_by_chance(RandomStream& random) {
  world::Fault jump{Sensor::kOdometry, FaultKind::kJump, 0.0, 0.0, {}};
  jump.jump = {hundredth(random.uniform(-2.0, 2.0)), hundredth(random.uniform(-2.0, 2.0)), degrees_by_chance(random)};
  return jump;
}

/// Nobody can search like that, and the robot can tell.
bool ends_the_search(const world::Change& change) {
  const auto* fault = std::get_if<world::Fault>(&change);
  if (fault == nullptr || fault->sensor == Sensor::kOdometry || fault->for_s < world::Fault{}.for_s) return false;
  return fault->kind == FaultKind::kOff || fault->kind == FaultKind::kStuck || fault->kind == FaultKind::kGarbage;
}

/// Where the robot cannot be that soon: it drives 0.3 m/s at most.
constexpr double kFirst_s = 2.0, kSoon_s = 4.0, kFar_m = 2.0;
constexpr double kDropped_m = 0.3, kWalk_m = 0.5;

class Draw {
 public:
  Draw(const Stage& stage, std::uint64_t seed, int number)
      : stage_(stage), random_(seed, "random_scenario/" + std::to_string(number)) {
    scenario_.name = "random-" + std::to_string(seed) + "-" + std::to_string(number);
    scenario_.about =
        "By chance: --random with --seed " + std::to_string(seed) + ", number " + std::to_string(number) + ".";
    scenario_.world = stage.world;
    scenario_.seed = 1 + random_.below(1000);
    scenario_.time_limit_s = kTimeLimit_s;
  }

  Scenario scenario() {
    const std::size_t count = 1 + random_.below(kMostObjects - 1);
    for (; used_ < count; ++used_) {
      scenario_.script.events.push_back({{}, stage_.objects[used_]});
      there_.push_back(stage_.objects[used_].name);
    }
    const std::uint64_t luck = random_.below(kTenths);
    const int disturbances = luck < 3 ? 0 : luck < 8 ? 1 : 2;
    for (int i = 0; i < disturbances; ++i) disturb(i == 0);
    scenario_.expect.numbers["collisions"] = {{}, 0.0};
    scenario_.expect.end = {"explored"};
    if (misled_) scenario_.expect.end = {"explored", "lost", "sensor_lost"};
    if (hopeless_) scenario_.expect.end = {"lost", "sensor_lost"};
    if (altered_) scenario_.expect.end.emplace_back("gave_up");
    if (!misled_ && !altered_) scenario_.expect.found = there_;
    return scenario_;
  }

 private:
  void disturb(bool first) {
    world::Event event;
    event.change = change(first);
    moment_s_ = first ? tenth(random_.uniform(kFirst_s, soon_ ? kSoon_s : 10.0))
                      : tenth(moment_s_ + random_.uniform(0.5, 10.0));
    event.moment.after_s = moment_s_;
    misled_ = misled_ || std::holds_alternative<world::Fault>(event.change) ||
              std::holds_alternative<world::Kidnap>(event.change);
    hopeless_ = hopeless_ || (ends_the_search(event.change) && first);
    scenario_.script.events.push_back(event);
  }

  world::Change change(bool first) {
    const std::uint64_t what = random_.below(kTenths);
    if (what == 6) {
      const Eigen::Vector2d& to = stage_.standing_m[random_.below(stage_.standing_m.size())];
      return world::Kidnap{{to.x(), to.y(), degrees_by_chance(random_)}};
    }
    if (what == 7) return jump_by_chance(random_);
    if (what >= 8 && first) {
      const auto changed = what == 8 ? object_change() : room_change();
      soon_ = changed.has_value();
      if (changed) return *changed;
    }
    if (what >= 8 && !there_.empty()) {
      const std::string gone = there_.back();
      there_.pop_back();
      return world::RemoveBody{gone};
    }
    return fault_by_chance(random_);
  }

  /// An object that appears, is dropped or moved; nothing where it is to be taken away, or has no place.
  std::optional<world::Change> object_change() {
    const std::uint64_t how = random_.below(4);
    if (how == 0) return std::nullopt;
    if (how == 1) {
      const auto to = far_place();
      if (!to) return std::nullopt;
      const std::string moved = there_.back();
      there_.pop_back();
      return world::MoveBody{moved, {to->x(), to->y(), {}, degrees_by_chance(random_)}};
    }
    const auto far = std::find_if(stage_.objects.begin() + static_cast<std::ptrdiff_t>(used_), stage_.objects.end(),
                                  [&](const world::AddBody& o) {
                                    return is_far({o.place.x_m, o.place.y_m});
                                  });
    if (far == stage_.objects.end()) return std::nullopt;
    world::AddBody added = *far;
    if (how == 2) added.place.z_m = kDropped_m;
    return added;
  }

  std::optional<world::Change> room_change() {
    const std::uint64_t how = random_.below(4);
    const auto to = far_place(), from = far_place();
    const double yaw_rad = degrees_by_chance(random_);
    if (how == 0 && stage_.doors.empty()) return std::nullopt;
    if (how == 1 && stage_.chairs.empty()) return std::nullopt;
    if (how != 0 && (!to || !from || (how == 2 && (*to - *from).norm() < kWalk_m))) return std::nullopt;
    altered_ = true;
    if (how == 0) return stage_.doors[random_.below(stage_.doors.size())];
    if (how == 1)
      return world::MoveBody{stage_.chairs[random_.below(stage_.chairs.size())], {to->x(), to->y(), {}, yaw_rad}};
    if (how == 2) return world::Walk{"somebody", {*from, *to}, tenth(random_.uniform(0.4, 1.0))};
    return world::AddBody{kObstacle, kObstacle, {to->x(), to->y(), {}, yaw_rad}};
  }

  [[nodiscard]] bool is_far(const Eigen::Vector2d& place_m) const {
    return (place_m - stage_.start_m).norm() >= kFar_m;
  }
  std::optional<Eigen::Vector2d> far_place() {
    std::vector<Eigen::Vector2d> places;
    std::copy_if(stage_.standing_m.begin(), stage_.standing_m.end(), std::back_inserter(places),
                 [this](const Eigen::Vector2d& p) { return is_far(p); });
    if (places.empty()) return std::nullopt;
    return places[random_.below(places.size())];
  }

  const Stage& stage_;
  RandomStream random_;
  Scenario scenario_;
  std::vector<std::string> there_;  // from the beginning and to the end
  std::size_t used_ = 0;
  double moment_s_ = 0.0;
  bool misled_ = false, hopeless_ = false;
  bool altered_ = false;  // the room, so that not all may be reached
  bool soon_ = false;     // while the robot is at the start
};

}  // namespace

Scenario random_scenario(const Stage& stage, std::uint64_t seed, int number) {
  assert(stage.objects.size() >= kMostObjects && !stage.standing_m.empty());
  return Draw(stage, seed, number).scenario();
}

}  // namespace amiss::scenario
