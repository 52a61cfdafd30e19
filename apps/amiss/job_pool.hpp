// Jobs in processes of their own, some at a time: what one of them breaks stays with it.
// Each job runs in a fork of this process, which must have no threads; its result is the job's exit status. When the
// program is interrupted no more jobs are begun and those at work are told to stop.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace amiss::app {

struct Job {
  std::string name;
  std::function<int()> run;
};

struct JobResult {
  std::string name;
  int status = 0;  // of the exit; 128 + signal where a signal ended it
};

/// `done` is told of each job that ended, in the order in which they end. The results are in the order of the jobs,
/// without those that were not begun.
[[nodiscard]] std::vector<JobResult> run_jobs(const std::vector<Job>& jobs, int at_a_time,
                                              const std::function<void(const JobResult&)>& done);

}  // namespace amiss::app
