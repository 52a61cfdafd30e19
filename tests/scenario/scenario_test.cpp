#include "scenario/scenario.hpp"

#include <gtest/gtest.h>

namespace amiss::scenario {
namespace {

world::Event add(const std::string& kind, const std::string& name) { return {{}, world::AddBody{kind, name, {}}}; }

TEST(Scenario, BreaksReplaceWhatTheyName) {
  Scenario scenario;
  scenario.params = {{"a", "1", ""}};
  scenario.script.events = {add("mug", "mug")};
  scenario.time_limit_s = 60.0;
  Break how;
  how.params = {{"a", "2", ""}};
  scenario.breaks = {how};
  const Scenario one = broken(scenario, how);
  ASSERT_EQ(one.params.size(), 2U);
  EXPECT_EQ(one.params[1].value, "2") << "the later one counts";
  EXPECT_EQ(one.script.events.size(), 1U);
  EXPECT_EQ(one.time_limit_s, 60.0);
  EXPECT_FALSE(one.until_found);
  how.script = world::Script{};
  how.until_found = true;
  how.time_limit_s = 5.0;
  const Scenario other = broken(scenario, how);
  EXPECT_TRUE(other.script.events.empty());
  EXPECT_TRUE(other.until_found);
  EXPECT_EQ(other.time_limit_s, 5.0);
}

TEST(Scenario, NamesWhatTheScriptNeeds) {
  world::Script script{{add("mug", "one"), add("stool", "two"), add("mug", "three")}};
  EXPECT_EQ(kinds_of(script), (std::vector<std::string>{"mug", "stool"}));
  script.events.push_back({{}, world::Walk{"anna", {{0, 0}, {1, 1}}, 1.0}});
  EXPECT_EQ(kinds_of(script), (std::vector<std::string>{"mug", "person", "stool"}));
  EXPECT_EQ(names_of(script), (std::vector<std::string>{"one", "two", "three", "anna"}));
}

}  // namespace
}  // namespace amiss::scenario
