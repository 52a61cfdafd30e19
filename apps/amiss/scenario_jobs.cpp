#include "scenario_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/files.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;
using experiment::last_line;
using Json = nlohmann::ordered_json;

void judge_as_it_is(const Json& findings, JobResult& result) {
  for (const Json& f : findings) {
    if (f["holds"].get<bool>()) continue;
    result.exit_status = kGoalNotMet;
    result.sentences.push_back(f["what"].get<std::string>() + ": " + f["sentence"].get<std::string>());
  }
}

/// A broken scenario is as expected when what it should break is broken.
void judge_broken(const Json& findings, JobResult& result) {
  const auto& must = result.job.must_fail;
  std::vector<std::string> failed;
  for (const Json& f : findings) {
    if (!f["holds"].get<bool>()) failed.push_back(f["what"].get<std::string>());
  }
  const bool shown = std::any_of(failed.begin(), failed.end(), [&](const std::string& what) {
    return must.empty() || std::find(must.begin(), must.end(), what) != must.end();
  });
  if (shown) return;
  result.exit_status = kGoalNotMet;
  result.sentences.push_back(fmt::format("broken on purpose, {} should have failed; what failed: {}",
                                         must.empty() ? "something" : fmt::format("{}", fmt::join(must, " or ")),
                                         failed.empty() ? "nothing" : fmt::format("{}", fmt::join(failed, ", "))));
}

report::JunitCase case_of(const JobResult& result) {
  using Kind = report::JunitCase::Kind;
  const Kind kind = result.exit_status == kGoalMet      ? Kind::kPassed
                    : result.exit_status == kGoalNotMet ? Kind::kFailed
                                                        : Kind::kError;
  return {result.job.name,
          result.job.file.string(),
          result.wall_s,
          kind,
          fmt::format("{}", fmt::join(result.sentences, "; ")),
          result.log};
}

}  // namespace

std::vector<ScenarioJob> jobs_of(const scenario::Scenario& scenario, bool prove) {
  std::vector<ScenarioJob> jobs{{scenario.file, -1, scenario.name, {}}};
  for (std::size_t i = 0; prove && i < scenario.breaks.size(); ++i) {
    jobs.push_back({scenario.file, static_cast<int>(i), fmt::format("{}, broken {}", scenario.name, i + 1),
                    scenario.breaks[i].fails});
  }
  return jobs;
}

std::string to_text(const ScenarioOutcome& outcome) {
  Json json;
  json["simulated_s"] = outcome.simulated_s;
  json["findings"] = Json::array();
  for (const score::Finding& f : outcome.findings) {
    json["findings"].push_back({{"what", f.what}, {"holds", f.holds}, {"sentence", f.sentence}});
  }
  json["log"] = outcome.log;
  return json.dump(1) + "\n";
}

std::string run_job(const scenario::Scenario& scenario, int break_index, bool threaded, const fs::path& keep) {
  const bool as_it_is = break_index < 0;
  const ScenarioOutcome outcome = run_scenario(
      as_it_is ? scenario : scenario::broken(scenario, scenario.breaks.at(static_cast<std::size_t>(break_index))),
      threaded);
  if (!keep.empty()) {
    save_atomically(keep.string() + ".log", outcome.log);
    save_atomically(keep.string() + ".png", outcome.picture_png);
  }
  return to_text(outcome);
}

JobResult judge_job(const ScenarioJob& job, const experiment::Ended& child) {
  JobResult result;
  result.job = job;
  const auto fail = [&](int status, std::string sentence) {
    result.exit_status = status;
    result.sentences = {std::move(sentence)};
  };
  if (child.stopped) {
    fail(kProgramFailed, "it hung: no end after the time limit of a run");
  } else if (child.signal != 0) {
    fail(kProgramFailed, fmt::format("the program crashed (signal {})", child.signal));
  } else if (child.status == kWrongArguments || child.status == kUnreadableInput) {
    fail(child.status, last_line(child.err));
  } else if (child.status != kGoalMet) {
    fail(kProgramFailed, fmt::format("the program failed (status {}): {}", child.status, last_line(child.err)));
  } else {
    const Json json = Json::parse(child.out);
    result.simulated_s = json["simulated_s"].get<double>();
    result.log = json["log"].get<std::string>();
    if (job.break_index < 0) {
      judge_as_it_is(json["findings"], result);
    } else {
      judge_broken(json["findings"], result);
    }
  }
  return result;
}

std::vector<report::JunitCase> junit_of(const std::vector<JobResult>& results) {
  std::vector<report::JunitCase> cases;
  for (const JobResult& r : results) {
    if (r.finished) cases.push_back(case_of(r));
  }
  return cases;
}

std::string_view verdict_of(const JobResult& result) {
  return result.exit_status == kGoalMet ? "ok" : result.exit_status == kGoalNotMet ? "FAILED" : "ERROR";
}

std::string line_of(const JobResult& result) {
  std::string text = fmt::format("{:<7} {:<40} {:6.1f} s simulated, {:5.1f} s\n", verdict_of(result), result.job.name,
                                 result.simulated_s, result.wall_s);
  for (const std::string& sentence : result.sentences) text += "        " + sentence + "\n";
  return text;
}

}  // namespace amiss::app
