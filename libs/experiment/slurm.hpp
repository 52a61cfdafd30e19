// The commands of Slurm (22.05 and later): how large an array may be, a script handed over, what of it is in the queue.
// Errors of Slurm are SlurmErrors that say which command failed and what it said.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/process.hpp"

namespace amiss::experiment {

struct SlurmError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr int kUsualMaxArraySize = 1001;  // where nothing else is configured

struct QueuedTask {
  std::string job;  // its name
  std::string id;   // of its array
  int task = 0;     // of the array
  bool runs = false;
  bool given_up = false;  // held by Slurm itself after it could not be begun: it never runs
  std::string reason;     // why it does not run yet
};

class Slurm {
 public:
  /// Runs a command and waits for it.
  using Call = std::function<Ended(const std::vector<std::string>& words)>;
  explicit Slurm(Call call) : call_(std::move(call)) {}

  [[nodiscard]] int max_array_size() const;  // a task's number is less than this
  void submit(const std::filesystem::path& script) const;
  /// The tasks of jobs of these names that wait, run or are about to end.
  [[nodiscard]] std::vector<QueuedTask> queue(const std::vector<std::string>& names) const;
  void cancel(const std::vector<std::string>& names) const;
  void cancel_task(const QueuedTask& task) const;

 private:
  [[nodiscard]] std::string output_of(const std::vector<std::string>& words) const;

  Call call_;
};

/// Of `scontrol show config`, and of `squeue` in the form that is asked for; SlurmErrors when they are not that.
[[nodiscard]] int parse_max_array_size(std::string_view config);
[[nodiscard]] std::vector<QueuedTask> parse_queue(std::string_view table);

}  // namespace amiss::experiment
