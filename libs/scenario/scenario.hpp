// A scenario: where a robot searches, what happens meanwhile, what the run is expected to show, and what must make it
// fail. Values; read from files by scenario_file.hpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/frames.hpp"
#include "score/expectation.hpp"
#include "world/script.hpp"

namespace amiss::scenario {

/// One parameter that differs from its default.
struct Setting {
  std::string key, value;
  std::string where;  // "file:line:column", for the sentence about a wrong one
};

/// How to break the behaviour that a scenario watches: what replaces the scenario's own.
struct Break {
  std::string why;
  std::vector<Setting> params;
  std::optional<world::Script> script;
  std::optional<bool> until_found;
  std::optional<double> time_limit_s;
  std::vector<std::string> fails;  // keys of expectations of which at least one must fail; empty: any
};

struct Scenario {
  std::filesystem::path file;
  std::string name, about;
  std::string world;  // name or file
  std::uint64_t seed = 1;
  bool until_found = false;  // or until all was explored
  double time_limit_s = 120.0;
  std::optional<Pose2<World, Base>> start;
  std::vector<Setting> params;            // of the search
  std::vector<Setting> reference_params;  // of the search and of the mapping run before it
  world::Script script;
  score::Expectations expect;
  std::vector<Break> breaks;
};

[[nodiscard]] Scenario broken(const Scenario& scenario, const Break& how);

/// Kinds of bodies that the script adds, each once, sorted; "person" where somebody walks.
[[nodiscard]] std::vector<std::string> kinds_of(const world::Script& script);
/// Names of the bodies that the script adds, walkers included, in its order.
[[nodiscard]] std::vector<std::string> names_of(const world::Script& script);

}  // namespace amiss::scenario
