#include "scenario/random_scenario.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "scenario/scenario_file.hpp"

namespace amiss::scenario {
namespace {

const Vocabulary kWords{{"mug", "toy_car"}, {"basket_laundry"}};

Stage stage() {
  Stage stage{"lab", {}, {{1.0, 2.0}, {3.0, 0.5}, {2.5, 2.0}}, {0.0, 1.0}, {{"leaf", "frame"}}, {"chair"}};
  for (int i = 0; i < 5; ++i) {
    stage.objects.push_back({i % 2 == 0 ? "mug" : "toy_car", "thing_" + std::to_string(i), {0.7 * i, 1.0, {}, 0.0}});
  }
  return stage;
}

TEST(RandomScenario, IsAFunctionOfSeedAndNumber) {
  std::set<std::string> texts;
  for (int number = 0; number < 30; ++number) {
    const std::string text = to_yaml(random_scenario(stage(), 7, number), kWords);
    EXPECT_EQ(to_yaml(random_scenario(stage(), 7, number), kWords), text);
    texts.insert(text);
  }
  EXPECT_EQ(texts.size(), 30U);
  EXPECT_FALSE(texts.contains(to_yaml(random_scenario(stage(), 8, 0), kWords)));
}

TEST(RandomScenario, ItsFileIsReadBack) {
  for (int number = 0; number < 200; ++number) {
    const Scenario s = random_scenario(stage(), 3, number);
    const std::string text = to_yaml(s, kWords);
    const Scenario again = parse_scenario(text, s.name + ".yaml", kWords);
    EXPECT_EQ(again.name, s.name);
    EXPECT_EQ(to_yaml(again, kWords), text);
  }
}

/// What a scenario does, counted.
struct Count {
  int faults = 0, kidnappings = 0, jumps = 0, gone = 0, later = 0, first = 0;
  int doors = 0, chairs = 0, walks = 0, blocks = 0, moved = 0, dropped = 0;
  bool hopeless = false;  // blind or deaf from the first disturbance on
  std::set<std::string> there;

  explicit Count(const Scenario& scenario) {
    for (const world::Event& event : scenario.script.events) {
      const bool begins = event.moment.after_s == 0.0;
      first += begins ? 1 : 0;
      if (const auto* fault = std::get_if<world::Fault>(&event.change)) {
        const std::set<world::FaultKind> nothing{world::FaultKind::kOff, world::FaultKind::kStuck,
                                                 world::FaultKind::kGarbage};
        if (all() == 0) {
          hopeless = fault->for_s == 1e9 && fault->sensor != world::Sensor::kOdometry && nothing.contains(fault->kind);
        }
        (fault->kind == world::FaultKind::kJump ? jumps : faults) += 1;
      }
      if (std::holds_alternative<world::Kidnap>(event.change)) ++kidnappings;
      if (const auto* removed = std::get_if<world::RemoveBody>(&event.change)) {
        ++gone;
        EXPECT_EQ(there.erase(removed->name), 1U);
      }
      if (const auto* added = std::get_if<world::AddBody>(&event.change)) {
        if (begins) there.insert(added->name);
        if (!begins) ++(added->kind == kObstacle ? blocks : later);
        if (!begins && added->place.z_m) ++dropped;
      }
      if (std::holds_alternative<world::CloseDoor>(event.change)) ++doors;
      if (std::holds_alternative<world::Walk>(event.change)) ++walks;
      if (const auto* move = std::get_if<world::MoveBody>(&event.change)) {
        ++(move->name == "chair" ? chairs : moved);
        if (move->name != "chair") {
          EXPECT_EQ(there.erase(move->name), 1U);
        }
      }
    }
  }
  [[nodiscard]] bool altered() const { return doors + chairs + walks + blocks > 0; }
  [[nodiscard]] int all() const {
    return faults + kidnappings + jumps + gone + later + moved + doors + chairs + walks + blocks;
  }
  [[nodiscard]] bool misled() const { return faults + kidnappings + jumps > 0; }
};

TEST(RandomScenario, ExpectsWhatMustHold) {
  for (int number = 0; number < 600; ++number) {
    const Scenario s = random_scenario(stage(), 5, number);
    const Count count(s);
    EXPECT_EQ(s.expect.numbers.at("collisions").most, 0.0);
    const std::set<std::string> ends(s.expect.end.begin(), s.expect.end.end());
    std::set<std::string> honest{"explored"};
    if (count.misled()) honest.insert({"lost", "sensor_lost"});
    if (count.altered()) honest.insert("gave_up");
    if (count.hopeless) honest.erase("explored");
    EXPECT_EQ(ends, honest);
    const std::set<std::string> found(s.expect.found.begin(), s.expect.found.end());
    EXPECT_EQ(found, count.misled() || count.altered() ? std::set<std::string>{} : count.there);
  }
}

TEST(RandomScenario, PutsNothingWhereTheRobotMayStand) {
  for (int number = 0; number < 600; ++number) {
    for (const world::Event& event : random_scenario(stage(), 6, number).script.events) {
      const double at_s = event.moment.after_s;
      EXPECT_TRUE(at_s == 0.0 || (at_s >= 2.0 && at_s <= 20.0)) << at_s;
      std::vector<Eigen::Vector2d> places;
      const auto note = [&](const world::Place& p) { places.emplace_back(p.x_m, p.y_m); };
      if (const auto* added = std::get_if<world::AddBody>(&event.change)) note(added->place);
      if (const auto* moved = std::get_if<world::MoveBody>(&event.change)) note(moved->place);
      if (const auto* walk = std::get_if<world::Walk>(&event.change)) places = walk->way_m;
      const bool closes = std::holds_alternative<world::CloseDoor>(event.change);
      if (at_s == 0.0 || (places.empty() && !closes)) continue;
      EXPECT_LE(at_s, 4.0);
      for (const Eigen::Vector2d& p : places) EXPECT_GE(std::hypot(p.x(), p.y() - 1.0), 2.0);
    }
  }
}

TEST(RandomScenario, DrawsFromWhatIsPromised) {
  constexpr int kRuns = 3000;
  int calm = 0, two = 0, faults = 0, kidnappings = 0, jumps = 0, changes = 0, later = 0;
  std::array<int, 4> objects{};
  std::map<int, int> rare;
  for (int number = 0; number < kRuns; ++number) {
    const Count count(random_scenario(stage(), 7, number));
    ++objects.at(static_cast<std::size_t>(count.first));
    const int all = count.all();
    int i = 0;
    for (const int n : {count.doors, count.chairs, count.walks, count.blocks, count.moved, count.dropped})
      rare[i++] += n;
    calm += all == 0 ? 1 : 0;
    two += all == 2 ? 1 : 0;
    faults += count.faults;
    kidnappings += count.kidnappings;
    jumps += count.jumps;
    changes += all - count.faults - count.kidnappings - count.jumps;
    later += count.later;
  }
  EXPECT_EQ(objects[0], 0);
  for (const int number : {1, 2, 3}) EXPECT_NEAR(objects.at(static_cast<std::size_t>(number)), 1000, 120);
  EXPECT_NEAR(calm, 900, 110);
  EXPECT_NEAR(two, 600, 100);
  EXPECT_NEAR(faults, 1620, 150);  // 2700 disturbances
  for (const int times : {kidnappings, jumps}) EXPECT_NEAR(times, 270, 70);
  EXPECT_NEAR(changes, 540, 90);
  EXPECT_GT(later, 50);
  EXPECT_EQ(rare.size(), 6U);
  for (const auto& [what, times] : rare) EXPECT_GT(times, 20) << what;
}

}  // namespace
}  // namespace amiss::scenario
