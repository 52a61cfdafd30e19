// What `amiss experiment merge`, `verify` and `plot` do once their arguments are read: exit status (commands.hpp).
#pragma once

#include <filesystem>

namespace amiss::app {

/// Writes the tables and prints the short ones. 1: trials are missing or failed.
int merge_experiment(const std::filesystem::path& folder);
/// Draws the figures and writes report.html; data and scripts are there even when they cannot be drawn.
int plot_experiment(const std::filesystem::path& folder);
/// 1: something is wrong.
int verify_experiment(const std::filesystem::path& folder);

}  // namespace amiss::app
