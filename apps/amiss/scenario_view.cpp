#include "scenario_view.hpp"

#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/files.hpp"
#include "interrupt.hpp"
#include "run_page.hpp"
#include "scenario_jobs.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// report.json: how it ended, what was expected, and every number that can be expected.
std::string report_of(const scenario::Scenario& scenario, const ScenarioOutcome& outcome) {
  Json json;
  json["version"] = AMISS_VERSION;
  json["scenario"] = scenario.name;
  json["outcome"] = interrupted() ? "interrupted" : outcome.record.end;
  if (!outcome.record.why.empty()) json["why"] = outcome.record.why;
  json["as_expected"] = outcome.as_expected();
  json["findings"] = Json::parse(to_text(outcome))["findings"];
  for (const auto& [name, value] : outcome.record.numbers) {
    json["numbers"][name] = std::isfinite(value) ? Json(value) : Json();
  }
  return json.dump(2) + "\n";
}

}  // namespace

int view_scenario(const fs::path& file, const std::string& out, const ViewOptions& options, bool quiet) {
  const scenario::Scenario scenario = scenario::load_scenario(file, vocabulary_of(find_resources()));
  const report::RunFolder folder(out.empty() ? report::unused_folder("runs", "scenario-" + file.stem().string())
                                             : fs::path(out));
  folder.save("scenario.yaml", load_bytes(file));
  RunPage page(folder, options, true);
  const ScenarioShow show{folder, page};
  const auto began = std::chrono::steady_clock::now();
  const ScenarioOutcome outcome = run_scenario(scenario, true, &show);
  folder.save("log.txt", outcome.log);
  folder.save("map.png", outcome.picture_png);
  const std::string report = report_of(scenario, outcome);
  page.end(report);
  if (interrupted()) {
    folder.interrupt(report);
    return kInterrupted;
  }
  folder.finish(report);
  JobResult result = judge_job({file, -1, scenario.name, {}}, {0, 0, false, to_text(outcome), ""});
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  if (!quiet) std::cout << line_of(result) << "run folder: " << folder.path().string() << std::endl;
  page.linger();
  return result.exit_status;
}

}  // namespace amiss::app
