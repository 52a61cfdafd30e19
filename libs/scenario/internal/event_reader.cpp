#include "scenario/internal/event_reader.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace amiss::scenario::internal {

namespace {

using world::FaultKind;
using world::Moment;
using world::Sensor;

constexpr double kFarthest_m = 1000.0;
constexpr double kLongest_s = 1e5;
constexpr double kNear_m = 0.5;
const std::string kObstacle = "basket_laundry";

const std::vector<std::string> kChanges{"add",        "drop", "block",  "move", "remove",
                                        "close_door", "walk", "kidnap", "jump", "fault"};

double length(const YamlReader& map, const std::string& key) { return map.at(key).number(-kFarthest_m, kFarthest_m); }
double angle(const YamlReader& map) { return radians(map.number_or("yaw_deg", 0.0, -360.0, 360.0)); }

world::Place read_place(const YamlReader& map) {
  world::Place place{length(map, "x"), length(map, "y"), std::nullopt, angle(map)};
  if (const auto z = map.find("z")) place.z_m = z->number(-10.0, 10.0);
  return place;
}

/// A body of the catalogue (`object`) or a piece of furniture; its name is its kind where none is given.
world::AddBody read_add(const YamlReader& map, const Vocabulary& vocabulary) {
  map.allow({"object", "furniture", "name", "x", "y", "z", "yaw_deg"});
  const auto furniture = map.find("furniture");
  if (furniture && map.find("object")) map.fail("one of 'object' and 'furniture' is allowed");
  const std::string kind = furniture ? furniture->choice(vocabulary.furniture, "furniture")
                                     : map.at("object").choice(vocabulary.objects, "object");
  return {kind, map.text_or("name", kind), read_place(map)};
}

world::AddBody read_drop(const YamlReader& map, const Vocabulary& vocabulary) {
  map.allow({"object", "name", "x", "y", "from", "yaw_deg"});
  const std::string kind = map.at("object").choice(vocabulary.objects, "object");
  world::Place place{length(map, "x"), length(map, "y"), map.number_or("from", 0.3, 0.0, 3.0), angle(map)};
  return {kind, map.text_or("name", kind), place};
}

world::AddBody read_block(const YamlReader& map, const Vocabulary& vocabulary) {
  map.allow({"with", "name", "x", "y", "yaw_deg"});
  const auto with = map.find("with");
  const std::string kind = with ? with->choice(vocabulary.furniture, "furniture") : kObstacle;
  return {kind, map.text_or("name", kind), read_place(map)};
}

world::MoveBody read_move(const YamlReader& map) {
  map.allow({"name", "x", "y", "z", "yaw_deg"});
  return {map.at("name").text(), read_place(map)};
}

world::RemoveBody read_remove(const YamlReader& map) {
  map.allow({"name"});
  return {map.at("name").text()};
}

world::CloseDoor read_close(const YamlReader& map) {
  map.allow({"leaf", "frame"});
  return {map.at("leaf").text(), map.at("frame").text()};
}

world::Walk read_walk(const YamlReader& map) {
  map.allow({"name", "way", "speed"});
  world::Walk walk{map.text_or("name", "person"), {}, map.number_or("speed", 0.8, 0.05, 3.0)};
  for (const YamlReader& place : map.at("way").items()) {
    const auto numbers = place.items();
    if (numbers.size() != 2) place.fail("[x, y] is needed");
    walk.way_m.emplace_back(numbers[0].number(-kFarthest_m, kFarthest_m), numbers[1].number(-kFarthest_m, kFarthest_m));
  }
  if (walk.way_m.size() < 2) map.at("way").fail("at least two places are needed");
  return walk;
}

world::Fault read_jump(const YamlReader& map) {
  map.allow({"x", "y", "yaw_deg"});
  world::Fault fault{Sensor::kOdometry, FaultKind::kJump, 0.0, 0.0, {}};
  fault.jump = {map.number_or("x", 0.0, -10.0, 10.0), map.number_or("y", 0.0, -10.0, 10.0), angle(map)};
  return fault;
}

template <class Value, std::size_t N>
Value named(const YamlReader& word, const std::array<Value, N>& values, const std::string& of_what) {
  std::vector<std::string> names;
  for (const Value value : values) names.emplace_back(world::to_string(value));
  const std::string name = word.choice(names, of_what);
  return values[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
}

world::Fault read_fault(const YamlReader& map) {
  map.allow({"sensor", "kind", "for", "factor", "period", "delay"});
  world::Fault fault;
  fault.sensor = named(map.at("sensor"), std::array{Sensor::kCamera, Sensor::kLaser, Sensor::kOdometry}, "sensor");
  fault.kind = named(map.at("kind"),
                     std::array{FaultKind::kOff, FaultKind::kStuck, FaultKind::kGarbage, FaultKind::kWrong,
                                FaultKind::kSlow, FaultKind::kDelayed, FaultKind::kIntermittent},
                     "kind of fault");
  fault.for_s = map.number_or("for", fault.for_s, 0.02, 1e9);
  const auto only_for = [&](const char* key, bool fits) {
    const auto given = map.find(key);
    if (given && !fits)
      given->fail(std::string("'") + key + "' says nothing of a sensor that is " + std::string(to_string(fault.kind)));
  };
  const bool periodic = fault.kind == FaultKind::kSlow || fault.kind == FaultKind::kIntermittent;
  only_for("factor", fault.kind == FaultKind::kWrong);
  only_for("period", periodic);
  only_for("delay", fault.kind == FaultKind::kDelayed);
  if (fault.kind == FaultKind::kWrong) fault.amount = map.number_or("factor", 1.2, 0.1, 10.0);
  if (periodic) fault.amount = map.number_or("period", 1.0, 0.02, 60.0);
  if (fault.kind == FaultKind::kDelayed) fault.amount = map.number_or("delay", 0.3, 0.02, 5.0);
  return fault;
}

world::Change read_change(const YamlReader& item, const Vocabulary& vocabulary) {
  std::vector<std::string> given;
  for (const std::string& key : kChanges) {
    if (item.find(key)) given.push_back(key);
  }
  if (given.size() != 1) {
    std::string all;
    for (const std::string& key : kChanges) all += (all.empty() ? "" : ", ") + key;
    item.fail("exactly one of " + all + " is needed");
  }
  const std::string& key = given[0];
  const YamlReader map = item.at(key);
  if (key == "add") return read_add(map, vocabulary);
  if (key == "drop") return read_drop(map, vocabulary);
  if (key == "block") return read_block(map, vocabulary);
  if (key == "move") return read_move(map);
  if (key == "remove") return read_remove(map);
  if (key == "close_door") return read_close(map);
  if (key == "walk") return read_walk(map);
  if (key == "kidnap") return world::Kidnap{read_pose(map)};
  return key == "jump" ? read_jump(map) : read_fault(map);
}

Moment read_moment(const YamlReader& item) {
  const auto at = item.find("at"), when = item.find("when");
  if (at && when) item.fail("one of 'at' and 'when' is allowed");
  Moment moment;
  if (!when) {
    if (const auto after = item.find("after")) after->fail("'after' needs 'when'; 'at' is a time by itself");
    moment.after_s = at ? at->number(0.0, kLongest_s) : 0.0;
    return moment;
  }
  moment.after_s = item.number_or("after", 0.0, 0.0, kLongest_s);
  when->allow({"robot_near", "detected", "examined"});
  const auto near = when->find("robot_near"), detected = when->find("detected"), examined = when->find("examined");
  if ((near ? 1 : 0) + (detected ? 1 : 0) + (examined ? 1 : 0) != 1) {
    when->fail("exactly one of robot_near, detected, examined is needed");
  }
  if (near) {
    near->allow({"x", "y", "within"});
    moment.kind = Moment::Kind::kRobotNear;
    moment.place_m = {length(*near, "x"), length(*near, "y")};
    moment.within_m = near->number_or("within", kNear_m, 0.01, 100.0);
  } else {
    moment.kind = detected ? Moment::Kind::kDetected : Moment::Kind::kExamined;
    moment.object = (detected ? detected : examined)->text();
  }
  return moment;
}

}  // namespace

Pose2<World, Base> read_pose(const YamlReader& item) {
  item.allow({"x", "y", "yaw_deg"});
  return {length(item, "x"), length(item, "y"), angle(item)};
}

world::Event read_object(const YamlReader& item, const Vocabulary& vocabulary) {
  return {{}, read_add(item, vocabulary)};
}

world::Event read_event(const YamlReader& item, const Vocabulary& vocabulary) {
  std::vector<std::string> keys{"at", "when", "after"};
  keys.insert(keys.end(), kChanges.begin(), kChanges.end());
  item.allow(keys);
  return {read_moment(item), read_change(item, vocabulary)};
}

void check(const world::Script& script, const YamlReader& root) {
  std::set<std::string> names;
  for (const world::Event& event : script.events) {
    const auto* add = std::get_if<world::AddBody>(&event.change);
    const auto* walk = std::get_if<world::Walk>(&event.change);
    if (add == nullptr && walk == nullptr) continue;
    const std::string& name = add != nullptr ? add->name : walk->name;
    if (!names.insert(name).second) root.fail("the name '" + name + "' is there twice; names are unique");
  }
  for (const world::Event& event : script.events) {
    const std::string& object = event.moment.object;
    if (!object.empty() && !names.contains(object)) {
      root.fail("an event waits for '" + object + "', which nothing adds");
    }
  }
}

}  // namespace amiss::scenario::internal
