// Scenarios as YAML files (share/scenarios/README.md tells all keys). File, vocabulary -> Scenario; InputError with
// file, line and column, what is wrong and what is allowed. What save_scenario writes, load_scenario reads back.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/scenario.hpp"

namespace amiss::scenario {

/// The words that a file may use and that this library cannot know.
struct Vocabulary {
  std::vector<std::string> objects;    // kinds of the catalogue
  std::vector<std::string> furniture;  // other kinds that may be added
};

[[nodiscard]] Scenario load_scenario(const std::filesystem::path& file, const Vocabulary& vocabulary);
/// The same from a text; `file` is for names, sentences and what lies beside it.
[[nodiscard]] Scenario parse_scenario(const std::string& text, const std::filesystem::path& file,
                                      const Vocabulary& vocabulary);

/// Without breaks.
[[nodiscard]] std::string to_yaml(const Scenario& scenario, const Vocabulary& vocabulary);
void save_scenario(const std::filesystem::path& file, const Scenario& scenario, const Vocabulary& vocabulary);

}  // namespace amiss::scenario
