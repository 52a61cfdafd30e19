// What `amiss experiment` does once its arguments are read: exit status of each subcommand (commands.hpp).
// 1: trials are missing or failed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amiss::app {

inline constexpr const char *kLocalEngine = "local", *kSlurmEngine = "slurm", *kParallelEngine = "parallel";

struct ExperimentOptions {
  std::filesystem::path out;
  std::string engine = kLocalEngine;
  int jobs = 0;   // at a time; 0: 2, with Slurm as many as there is room for
  int chunk = 0;  // trials for each task; 0: 10 with Slurm, 1 with GNU parallel
  bool retry_failed = false;
  bool print = false;               // the scripts for Slurm alone
  std::vector<std::string> sbatch;  // options of sbatch
  std::vector<std::string> logins;  // machines for GNU parallel
};

int plan_experiment(const std::filesystem::path& spec, int jobs);
int run_experiment(const std::filesystem::path& spec, const ExperimentOptions& options);
int work_on_experiment(const std::filesystem::path& folder, const std::vector<std::string>& ids);
int show_experiment(const std::filesystem::path& folder);

}  // namespace amiss::app
