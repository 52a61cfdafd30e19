// One experiment in a Slurm queue: its arrays, numbered from 1, whose scripts stay in the experiment's folder (slurm/)
// until all is done, and what of them waits or runs. The jobs' names tell folder, plan and number, so that whoever has
// the folder finds its jobs again.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "experiment/array_script.hpp"
#include "experiment/folder.hpp"
#include "experiment/slurm.hpp"

namespace amiss::experiment {

struct SlurmOptions {
  int chunk = 10;                        // trials for each task
  int at_a_time = 0;                     // tasks of an array; 0: as many as the cluster has room for
  std::vector<std::string> sbatch;       // options of sbatch for each array, such as --partition=short
  std::chrono::milliseconds poll{5000};  // between two looks at the queue
};

/// The scripts for these trials: as many arrays as their tasks need. `first`: the number of the first.
[[nodiscard]] std::vector<std::string> slurm_scripts(const Folder& folder, const std::vector<Trial>& trials,
                                                     const std::string& program, const SlurmOptions& options,
                                                     int max_array_size, int first = 1);

void remove_scripts(const Folder& folder);  // and logs

class SlurmJobs {
 public:
  /// Takes up what was handed over before. SlurmError when Slurm is not there. The folder outlives it.
  SlurmJobs(const Folder& folder, std::string program, SlurmOptions options, Slurm::Call call);

  /// SlurmError when the first array is refused. What Slurm says when it refuses a later one, whose trials then stay
  /// behind, else nothing.
  std::string submit(const std::vector<Trial>& trials);
  /// What runs or will run. What Slurm gave up is ended, so that it counts as lost.
  [[nodiscard]] std::vector<QueuedTask> queue() const;
  /// Those that no task of the queue does.
  [[nodiscard]] std::vector<Trial> without(const std::vector<Trial>& trials,
                                           const std::vector<QueuedTask>& queue) const;
  /// The end of the log of the last task that had this trial.
  [[nodiscard]] std::string last_words(const Trial& trial) const;
  /// Of all jobs that were handed over.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Ends what is in the queue, removes the scripts.
  void forget() const;

 private:
  void adopt(int number);

  const Folder& folder_;
  std::string program_;
  SlurmOptions options_;
  Slurm slurm_;
  int max_array_size_;
  int last_ = 0;                                    // number of the last array that was accepted
  std::map<std::string, std::vector<Task>> tasks_;  // by the job's name
};

}  // namespace amiss::experiment
