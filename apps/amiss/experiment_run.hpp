// What `amiss experiment` does once its arguments are read: exit status of each subcommand (commands.hpp).
// 1: trials are missing or failed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amiss::app {

struct ExperimentOptions {
  std::filesystem::path out;
  int jobs = 2;
  bool retry_failed = false;
};

int plan_experiment(const std::filesystem::path& spec, int jobs);
int run_experiment(const std::filesystem::path& spec, const ExperimentOptions& options);
int work_on_experiment(const std::filesystem::path& folder, const std::vector<std::string>& ids);
int show_experiment(const std::filesystem::path& folder);

}  // namespace amiss::app
