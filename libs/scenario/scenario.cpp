#include "scenario/scenario.hpp"

#include <set>

namespace amiss::scenario {

Scenario broken(const Scenario& scenario, const Break& how) {
  Scenario result = scenario;
  result.breaks.clear();
  result.params.insert(result.params.end(), how.params.begin(), how.params.end());
  if (how.script) result.script = *how.script;
  result.until_found = how.until_found.value_or(scenario.until_found);
  result.time_limit_s = how.time_limit_s.value_or(scenario.time_limit_s);
  return result;
}

std::vector<std::string> kinds_of(const world::Script& script) {
  std::set<std::string> kinds;
  for (const world::Event& event : script.events) {
    if (const auto* add = std::get_if<world::AddBody>(&event.change)) kinds.insert(add->kind);
    if (std::holds_alternative<world::Walk>(event.change)) kinds.insert("person");
  }
  return {kinds.begin(), kinds.end()};
}

std::vector<std::string> names_of(const world::Script& script) {
  std::vector<std::string> names;
  for (const world::Event& event : script.events) {
    if (const auto* add = std::get_if<world::AddBody>(&event.change)) names.push_back(add->name);
    if (const auto* walk = std::get_if<world::Walk>(&event.change)) names.push_back(walk->name);
  }
  return names;
}

}  // namespace amiss::scenario
