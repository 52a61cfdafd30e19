// `amiss scenario --random`: scenarios by chance, written as files that run like any others.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace amiss::app {

struct RandomScenarios {
  int count = 0;
  std::uint64_t seed = 1;
  std::string world = "small_room";
};

/// The same bytes for the same wishes. Returns the files, in order.
[[nodiscard]] std::vector<std::filesystem::path> write_random_scenarios(const RandomScenarios& wanted,
                                                                        const std::filesystem::path& folder);

}  // namespace amiss::app
