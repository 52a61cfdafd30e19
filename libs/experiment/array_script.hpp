// Trials as tasks of a cluster: several for each task; a job array as a script for sbatch that needs nothing beside it,
// and the tasks read back from it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/trial.hpp"

namespace amiss::experiment {

using Task = std::vector<std::string>;  // ids of the trials that it does, one after the other

[[nodiscard]] std::vector<Task> tasks_of(const std::vector<Trial>& trials, int chunk);

struct ArrayScript {
  std::string name;  // of the job
  std::filesystem::path program, folder;
  std::filesystem::path log;         // of a task: this, its number and ".log"
  int at_a_time = 0;                 // tasks; 0: as many as there is room for
  std::vector<std::string> options;  // of sbatch
  std::vector<Task> tasks;           // task i of the array does tasks[i]
};

/// ArgumentError when an option is none.
[[nodiscard]] std::string to_text(const ArrayScript& script);
/// InputError naming `file` when it is no such script.
[[nodiscard]] std::vector<Task> parse_tasks(std::string_view script, const std::string& file);

}  // namespace amiss::experiment
