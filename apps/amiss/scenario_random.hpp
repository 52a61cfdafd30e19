// `amiss scenario --random`: scenarios by chance, written as files that run like any others.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scenario/scenario.hpp"

namespace amiss::app {

struct RandomScenarios {
  int count = 0;
  std::uint64_t seed = 1;
  std::string world = "small_room";
};

/// The same for the same wishes. Their world is a name or an absolute file.
[[nodiscard]] std::vector<scenario::Scenario> random_scenarios(const RandomScenarios& wanted);
/// As NAME.yaml in a folder, which is made where it is missing; a world that is a file is named by its way from there.
std::filesystem::path save_random_scenario(scenario::Scenario scenario, const std::filesystem::path& folder);

}  // namespace amiss::app
