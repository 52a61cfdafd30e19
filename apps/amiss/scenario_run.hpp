// One run of a scenario in this process: world, reference, script, search, findings.
#pragma once

#include <string>
#include <vector>

#include "report/run_folder.hpp"
#include "resources.hpp"
#include "scenario/scenario_file.hpp"

namespace amiss::app {

class RunPage;

struct ScenarioOutcome {
  std::vector<score::Finding> findings;
  score::RunRecord record;
  double simulated_s = 0.0;
  std::string log, picture_png;

  [[nodiscard]] bool as_expected() const;
};

/// Kinds of objects and furniture by the names of their folders.
[[nodiscard]] scenario::Vocabulary vocabulary_of(const Resources& resources);

/// Where a run is written down and shown while it goes on.
struct ScenarioShow {
  const report::RunFolder& folder;
  RunPage& page;
};

/// Errors: ArgumentError and InputError for a scenario that cannot be, others for a program that failed.
[[nodiscard]] ScenarioOutcome run_scenario(const scenario::Scenario& scenario, bool threaded,
                                           const ScenarioShow* show = nullptr);

}  // namespace amiss::app
