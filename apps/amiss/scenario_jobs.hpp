// Scenarios as jobs for child processes, and their results: as they are, and each broken on purpose.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiment/process.hpp"
#include "report/junit.hpp"
#include "scenario/scenario.hpp"
#include "scenario_run.hpp"

namespace amiss::app {

/// A scenario as it is, or broken in one of its ways.
struct ScenarioJob {
  std::filesystem::path file;
  int break_index = -1;
  std::string name;
  std::vector<std::string> must_fail;  // of a broken one: keys, of which one must; any where empty
};

/// The jobs of one scenario: itself, and its breaks where it is to be proved.
[[nodiscard]] std::vector<ScenarioJob> jobs_of(const scenario::Scenario& scenario, bool prove);

struct JobResult {
  ScenarioJob job;
  bool finished = false;  // or interrupted, or never begun: then nothing else says anything
  int exit_status = 0;    // 0 as expected, 1 an expectation failed, 2 and 3 a wrong scenario, 4 the program failed
  std::vector<std::string> sentences;
  std::string log;
  double simulated_s = 0.0, wall_s = 0.0;
};

/// What a child prints of its run.
[[nodiscard]] std::string to_text(const ScenarioOutcome& outcome);
/// In this process; what a child prints on standard output. `keep`: where a log and a floor plan go, as KEEP.log and
/// KEEP.png; nowhere when empty.
[[nodiscard]] std::string run_job(const scenario::Scenario& scenario, int break_index, bool threaded,
                                  const std::filesystem::path& keep);
/// What a child's end says of its job; one that was stopped was too slow.
[[nodiscard]] JobResult judge_job(const ScenarioJob& job, const experiment::Ended& child);

/// Of those that finished.
[[nodiscard]] std::vector<report::JunitCase> junit_of(const std::vector<JobResult>& results);
/// "ok", "FAILED" (an expectation) or "ERROR" (scenario or program).
[[nodiscard]] std::string_view verdict_of(const JobResult& result);
/// "ok       name   12.3 s (1.2 s)" and the sentences of what failed.
[[nodiscard]] std::string line_of(const JobResult& result);

}  // namespace amiss::app
