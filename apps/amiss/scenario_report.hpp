// report.html of several scripted runs: what was expected, what came, and the floor plan of each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario_jobs.hpp"

namespace amiss::app {

/// `kept`: of each result, where its log and floor plan lie, without the ending.
[[nodiscard]] std::string scenarios_page(const std::vector<JobResult>& results,
                                         const std::vector<std::filesystem::path>& kept);

}  // namespace amiss::app
