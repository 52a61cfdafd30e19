// One scenario in this process, watched: a page while it goes on, a run folder and report.html when it is over.
#pragma once

#include <filesystem>
#include <string>

#include "view_options.hpp"

namespace amiss::app {

/// `out`: the run folder, runs/scenario-NAME where it is empty. Returns the exit status.
/// Errors: those of run_scenario(), and of a folder that holds something else.
[[nodiscard]] int view_scenario(const std::filesystem::path& file, const std::string& out, const ViewOptions& options,
                                bool quiet);

}  // namespace amiss::app
