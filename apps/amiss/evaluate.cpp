// amiss evaluate chapter5 DATASET: Table 5.2 of the thesis on a data set in ObChange's layout.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <future>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "evaluate_trials.hpp"
#include "experiment/table_markup.hpp"
#include "interrupt.hpp"
#include "time_left.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr double kGuess_s = 20.0;  // of a visit

struct Arguments {
  std::string dataset, out;
  std::vector<std::string> methods{"all"};
  DetectSettings settings;
  int jobs = 1;
  bool quiet = false;
};

/// Of the table, in the order of the thesis: baselines first.
const std::vector<std::string>& methods_in_order() {
  static const std::vector<std::string> kOrder = {"octomap",   "metaroom",        "semantic",
                                                  "no-planes", "no-verification", "local-verification"};
  return kOrder;
}

std::vector<std::string> chosen_methods(const std::vector<std::string>& words) {
  if (words == std::vector<std::string>{"all"}) return methods_in_order();
  for (const std::string& word : words) {
    if (std::find(methods_in_order().begin(), methods_in_order().end(), word) != methods_in_order().end()) continue;
    throw ArgumentError("--methods " + word + ": is none; allowed are all, " +
                        fmt::format("{}", fmt::join(methods_in_order(), ", ")));
  }
  std::vector<std::string> chosen = methods_in_order();
  std::erase_if(chosen, [&](const std::string& m) { return std::find(words.begin(), words.end(), m) == words.end(); });
  return chosen;
}

std::vector<TrialResult> all_trials(const Arguments& a, const std::vector<Visit>& visits) {
  const std::vector<std::string> methods = chosen_methods(a.methods);
  const bool all = a.methods == std::vector<std::string>{"all"};
  TimeLeft time_left(kGuess_s / a.jobs, "visits");
  std::vector<TrialResult> results;
  for (std::size_t next = 0; next < visits.size() && !interrupted();) {
    std::vector<std::future<std::vector<TrialResult>>> together;
    for (int k = 0; k < a.jobs && next < visits.size(); ++k, ++next) {
      together.push_back(std::async(std::launch::async,
                                    [&, i = next] { return run_trials(visits[i], methods, a.settings, all, a.out); }));
    }
    for (auto& visit : together) {
      const std::vector<TrialResult> done = visit.get();
      results.insert(results.end(), done.begin(), done.end());
    }
    if (!a.quiet) time_left.show(next, visits.size());
  }
  if (!a.quiet) time_left.clear();
  return results;
}

experiment::Table table_of(const std::vector<TrialResult>& results) {
  std::vector<score::NovelTrial> trials;
  for (const TrialResult& r : results) trials.push_back(r.trial);
  experiment::Table table{
      {"room", "method", "precision", "precision_sd", "recall", "recall_sd", "f1", "f1_sd", "missed", "wrong"}, {}};
  const auto text = [](double v) { return fmt::format("{:.4f}", v); };
  for (const score::NovelRow& row : score::table52(trials)) {
    table.rows.push_back({row.room, row.method, text(row.precision.mean), text(row.precision.deviation),
                          text(row.recall.mean), text(row.recall.deviation), text(row.f1.mean), text(row.f1.deviation),
                          experiment::number_text(row.missed), experiment::number_text(row.wrong)});
  }
  return table;
}

/// What the numbers rest on.
std::vector<std::string> sentences_of(const std::vector<TrialResult>& results, const VisitList& list) {
  std::vector<std::string> labels;
  std::size_t objects = 0, with_space = 0;
  const std::string first = results.front().trial.method;
  for (const TrialResult& r : results) {
    const std::string kind = r.labels.substr(0, r.labels.find(" of "));
    if (std::find(labels.begin(), labels.end(), kind) == labels.end()) labels.push_back(kind);
    if (r.trial.method != first) continue;
    objects += r.objects;
    with_space += r.space != "none" ? 1U : 0U;
  }
  std::vector<std::string> sentences = {
      fmt::format("{} visits with {} annotated objects. Labels: {}. Seen space is known for {} visits.",
                  list.visits.size(), objects, fmt::join(labels, "; "), with_space),
      "Precision, recall and F1 are counted over points; mean and standard deviation over the visits of a room, missed "
      "objects and wrong clusters summed. average: means of the rooms, deviations over all visits."};
  for (const std::string& why : list.left_out) sentences.push_back("Left out: " + why + ".");
  return sentences;
}

void save_tables(const Arguments& a, const std::vector<TrialResult>& results, const VisitList& list) {
  const fs::path out = a.out;
  const experiment::Table table = table_of(results);
  const std::vector<std::string> sentences = sentences_of(results, list);
  save_atomically(out / "params.yaml", a.settings.as_yaml());
  save_atomically(out / "table52.tsv", experiment::to_tsv(table));
  save_atomically(out / "table52.md",
                  fmt::format("{}\n\n{}", fmt::join(sentences, "\n\n"), experiment::to_markdown(table)));
  save_atomically(out / "table52.html", experiment::to_page("Novel objects: Table 5.2", sentences, table));
  double longest_s = 0.0;
  std::size_t before = 0;
  for (const TrialResult& r : results) {
    longest_s = std::max(longest_s, r.wall_s);
    before += r.done_before ? 1U : 0U;
  }
  const nlohmann::ordered_json report = {{"schema", "amiss.table52.1"},
                                         {"version", AMISS_VERSION},
                                         {"dataset", a.dataset},
                                         {"visits", list.visits.size()},
                                         {"trials", results.size()},
                                         {"left_out", list.left_out},
                                         {"wall", {{"longest_detection_s", longest_s}, {"done_before", before}}}};
  save_atomically(out / "report.json", report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (a.quiet) return;
  for (const std::string& sentence : sentences) std::cout << sentence << "\n";
  std::cout << experiment::to_columns(table);
}

int run(const Arguments& a) {
  catch_interrupts();
  (void)chosen_methods(a.methods);
  const VisitList list = annotated_visits(a.dataset);
  if (list.visits.empty()) {
    throw InputError(a.dataset + ": no scene has annotations (Annotations/scene<N>_GT.anno) and a reference (scene1)");
  }
  fs::create_directories(a.out);
  const std::vector<TrialResult> results = all_trials(a, list.visits);
  if (interrupted()) return kInterrupted;
  save_tables(a, results, list);
  return kGoalMet;
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& exit_status) {
  CLI::App* const evaluate = app.add_subcommand("evaluate", "what the methods of a chapter reach on a data set");
  evaluate->require_subcommand(1);
  const auto a = std::make_shared<Arguments>();
  CLI::App* const command = evaluate->add_subcommand("chapter5", "novel objects in full rooms: Table 5.2");
  command->add_option("DATASET", a->dataset, "folder of rooms in ObChange's layout, or one room")->required();
  command->add_option("--out", a->out, "folder to write; one that is not finished is continued")->required();
  command->add_option("--methods", a->methods, "all, or some separated by commas")->delimiter(',');
  command->add_option("-j,--jobs", a->jobs, "visits at a time")->check(CLI::Range(1, 64))->capture_default_str();
  a->settings.add_options(*command);
  command->add_flag("--quiet", a->quiet, "no progress, no table");
  command->callback([a, &exit_status] {
    a->settings.load();
    exit_status = run(*a);
  });
}

}  // namespace amiss::app
