#include "scenario/scenario_file.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::scenario {
namespace {

const Vocabulary kWords{{"mug", "toy_car"}, {"stool", "basket_laundry"}};

Scenario parsed(const std::string& text) { return parse_scenario(text, "folder/s.yaml", kWords); }

/// The sentence about a wrong file.
std::string refusal(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

const std::string kWhole = R"(about: all of it
world: lab
seed: 7
until: found
time_limit: 30
start: {x: 1, y: 2, yaw_deg: 90}
params:
  change: {min_voxels: 3}
  search.look: 1.5
reference_params: {mapping.resolution: 0.1}
objects:
  - {object: mug, x: 1, y: 2}
  - {furniture: stool, name: seat, x: 1, y: 3, yaw_deg: 45}
events:
  - {at: 3, drop: {object: toy_car, x: 2, y: 1, from: 0.4}}
  - {at: 4, block: {x: 3, y: 1}}
  - {when: {robot_near: {x: 1, y: 1, within: 0.3}}, after: 2, move: {name: mug, x: 2, y: 2, z: 0.5}}
  - {when: {detected: mug}, remove: {name: seat}}
  - {when: {examined: mug}, close_door: {leaf: l, frame: f}}
  - {at: 5, walk: {way: [[0, 0], [1, 0.5]], speed: 0.5}}
  - {at: 6, kidnap: {x: 1, y: 1}}
  - {at: 7, jump: {x: 0.4}}
  - {at: 8, fault: {sensor: camera, kind: slow, for: 5, period: 2}}
  - {at: 9, fault: {sensor: laser, kind: wrong, factor: 1.5}}
expect:
  found: [mug, toy_car]
  not_found: seat
  not_detected: [seat]
  found_by: {mug: 20}
  category: {mug: novel}
  end: found
  exit_status: 0
  collisions: 0
  regions: {min: 1, max: 3}
  plans: {min: 2}
breaks:
  - {why: blind, params: {change.min_voxels: 99}, fails: [found]}
  - {until: explored, time_limit: 9, events: []}
)";

TEST(ScenarioFile, ReadsAllOfIt) {
  const Scenario s = parsed(kWhole);
  EXPECT_EQ(s.name, "s");
  EXPECT_EQ(s.seed, 7U);
  EXPECT_TRUE(s.until_found);
  EXPECT_NEAR(s.start->yaw_rad, radians(90.0), 1e-12);
  ASSERT_EQ(s.params.size(), 2U);
  EXPECT_EQ(s.params[0].key, "change.min_voxels");
  EXPECT_EQ(s.params[1].value, "1.5");
  EXPECT_EQ(s.params[1].where, "folder/s.yaml:9:16");
  ASSERT_EQ(s.script.events.size(), 12U);
  const auto& seat = std::get<world::AddBody>(s.script.events[1].change);
  EXPECT_EQ(seat.kind, "stool");
  EXPECT_FALSE(seat.place.z_m);
  EXPECT_EQ(std::get<world::AddBody>(s.script.events[2].change).place.z_m, 0.4);
  EXPECT_EQ(std::get<world::AddBody>(s.script.events[3].change).kind, "basket_laundry");
  EXPECT_EQ(s.script.events[4].moment.kind, world::Moment::Kind::kRobotNear);
  EXPECT_EQ(s.script.events[4].moment.after_s, 2.0);
  EXPECT_EQ(s.script.events[5].moment.object, "mug");
  EXPECT_EQ(std::get<world::Walk>(s.script.events[7].change).way_m.size(), 2U);
  EXPECT_EQ(std::get<world::Fault>(s.script.events[9].change).jump.x_m, 0.4);
  EXPECT_EQ(std::get<world::Fault>(s.script.events[10].change).amount, 2.0);
  EXPECT_EQ(s.expect.not_found, std::vector<std::string>{"seat"});
  EXPECT_EQ(s.expect.numbers.at("collisions").most, 0.0);
  EXPECT_FALSE(s.expect.numbers.at("plans").most);
  ASSERT_EQ(s.breaks.size(), 2U);
  EXPECT_EQ(s.breaks[0].fails, std::vector<std::string>{"found"});
  EXPECT_FALSE(s.breaks[0].script);
  EXPECT_TRUE(s.breaks[1].script->events.empty());
  EXPECT_EQ(s.breaks[1].until_found, false);
}

TEST(ScenarioFile, WhatIsSavedIsReadBack) {
  const Scenario s = parsed(kWhole);
  const std::string text = to_yaml(s, kWords);
  EXPECT_EQ(to_yaml(parsed(text), kWords), text);
  test::TemporaryFolder folder;
  save_scenario(folder.path() / "again.yaml", s, kWords);
  const Scenario again = load_scenario(folder.path() / "again.yaml", kWords);
  EXPECT_EQ(again.script.events.size(), s.script.events.size());
  EXPECT_EQ(again.expect.numbers.size(), s.expect.numbers.size());
  EXPECT_EQ(again.name, "again");
}

TEST(ScenarioFile, SaysLineAndColumnAndWhatIsAllowed) {
  const std::string head = "world: lab\nexpect: {}\n";
  EXPECT_EQ(refusal("world: lab\nexpect: {founf: [mug]}\n").substr(0, 79),
            "folder/s.yaml:2:10: unknown key 'founf'; did you mean 'found'? Allowed: found, ");
  EXPECT_EQ(refusal("world: lab\n"), "folder/s.yaml:1:1: 'expect' is missing");
  EXPECT_EQ(refusal(head + "objects:\n  - {object: mugg, x: 1, y: 2}\n"),
            "folder/s.yaml:4:14: no object 'mugg'; did you mean 'mug'? Allowed: mug, toy_car");
  EXPECT_EQ(refusal(head + "time_limit: soon\n"),
            "folder/s.yaml:3:13: 'soon' is not allowed: a number from 1 to 100000 is needed");
  EXPECT_EQ(
      refusal(head + "events:\n  - {at: 1}\n"),
      "folder/s.yaml:4:5: exactly one of add, drop, block, move, remove, close_door, walk, kidnap, jump, fault is "
      "needed");
  EXPECT_EQ(refusal(head + "events:\n  - {fault: {sensor: laser, kind: off, period: 2}}\n"),
            "folder/s.yaml:4:48: 'period' says nothing of a sensor that is off");
  EXPECT_EQ(refusal(head + "events:\n  - {at: 1, when: {detected: mug}, remove: {name: mug}}\n"),
            "folder/s.yaml:4:5: one of 'at' and 'when' is allowed");
  EXPECT_EQ(refusal("world: lab\nexpect: {end: [explored, fuond]}\n"),
            "folder/s.yaml:2:26: no end of a run 'fuond'; did you mean 'found'? Allowed: found, explored, time_limit, "
            "gave_up, lost, sensor_lost, stopped");
  EXPECT_EQ(refusal("world: lab\nexpect: {why: laser drunk}\n").substr(0, 52),
            "folder/s.yaml:2:15: no trouble 'laser drunk'; did yo");
  EXPECT_EQ(refusal("world: lab\nexpect: {navigation_errors: {blokked: 1}}\n").substr(0, 71),
            "folder/s.yaml:2:30: unknown key 'blokked'; did you mean 'blocked'? Allo");
  EXPECT_EQ(refusal(head + "breaks:\n  - {fails: [end]}\n"),
            "folder/s.yaml:4:14: 'end' should fail, but is not expected; Allowed: events");
  EXPECT_EQ(refusal("world: lab\nexpect: {found_by: {mug: 3}}\n"),
            "folder/s.yaml:2:9: 'mug' is expected, but nothing adds it");
  EXPECT_EQ(refusal(head + "seed: 1\nseed: 2\n"), "folder/s.yaml:4:1: the key 'seed' is there twice");
  EXPECT_EQ(refusal("world: lab\nexpect: {found: [mug]}\n"),
            "folder/s.yaml:2:9: 'mug' is expected, but nothing adds it");
  EXPECT_EQ(refusal(head + "objects:\n  - {object: mug, x: 1, y: 2}\n  - {object: mug, x: 1, y: 1}\n"),
            "folder/s.yaml:1:1: the name 'mug' is there twice; names are unique");
  EXPECT_EQ(refusal(head + "until: found\n"),
            "folder/s.yaml:2:9: 'until: found' needs 'found', the objects to be found");
  EXPECT_EQ(refusal(head + "events:\n  - {when: {detected: mug}, jump: {}}\n"),
            "folder/s.yaml:1:1: an event waits for 'mug', which nothing adds");
  EXPECT_NE(refusal("world: [\n").find("folder/s.yaml:2:1: not YAML"), std::string::npos) << refusal("world: [\n");
  EXPECT_EQ(refusal("- a\n").substr(0, 35), "folder/s.yaml:1:1: a map is needed,");
}

}  // namespace
}  // namespace amiss::scenario
