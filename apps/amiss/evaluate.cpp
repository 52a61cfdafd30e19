// amiss evaluate chapter5 DATASET: Table 5.2 of the thesis on a data set in ObChange's layout.
// amiss evaluate reconstructions NAME=DATASET...: the same over several reconstructions of the same rooms (5.3.6).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <future>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "core/result.hpp"
#include "evaluate_tables.hpp"
#include "interrupt.hpp"
#include "time_left.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr double kGuess_s = 20.0;  // of a visit

struct Arguments {
  std::vector<std::string> datasets;  // for `reconstructions` each as NAME=DATASET
  std::string out;
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

std::vector<TrialResult> all_trials(const Arguments& a, const std::vector<Visit>& visits, const fs::path& out) {
  const std::vector<std::string> methods = chosen_methods(a.methods);
  const bool all = a.methods == std::vector<std::string>{"all"};
  TimeLeft time_left(kGuess_s / a.jobs, "visits");
  std::vector<TrialResult> results;
  for (std::size_t next = 0; next < visits.size() && !interrupted();) {
    std::vector<std::future<std::vector<TrialResult>>> together;
    for (int k = 0; k < a.jobs && next < visits.size(); ++k, ++next) {
      together.push_back(std::async(std::launch::async,
                                    [&, i = next] { return run_trials(visits[i], methods, a.settings, all, out); }));
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

/// A data set with its annotated visits; InputError where it has none.
JudgedRooms rooms_of(const std::string& name, const std::string& dataset) {
  JudgedRooms rooms{name, dataset, annotated_visits(dataset), {}};
  if (rooms.list.visits.empty()) {
    throw InputError(dataset + ": no scene has annotations (Annotations/scene<N>_GT.anno) and a reference (scene1)");
  }
  return rooms;
}

/// "octomap=rooms/octomap" -> its two parts; the name is that of a folder.
JudgedRooms named_rooms(const std::string& word, const std::vector<JudgedRooms>& before) {
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const bool taken = std::any_of(before.begin(), before.end(), [&](const auto& o) { return o.reconstruction == name; });
  if (equals == std::string::npos || name.empty() || name.front() == '.' || name.find('/') != std::string::npos ||
      taken) {
    throw ArgumentError(word + ": NAME=DATASET is needed, with another name for each");
  }
  return rooms_of(name, word.substr(equals + 1));
}

int run(const Arguments& a, const std::string& stem, std::vector<JudgedRooms> judged) {
  catch_interrupts();
  fs::create_directories(a.out);
  for (JudgedRooms& rooms : judged) {
    rooms.results = all_trials(a, rooms.list.visits, fs::path(a.out) / rooms.reconstruction);
    if (interrupted()) return kInterrupted;
  }
  const SavedTable saved = save_tables(judged, a.settings, stem, a.out);
  if (a.quiet) return kGoalMet;
  for (const std::string& sentence : saved.sentences) std::cout << sentence << "\n";
  std::cout << experiment::to_columns(saved.table);
  return kGoalMet;
}

void add_common(CLI::App& command, Arguments& a) {
  command.add_option("--out", a.out, "folder to write; one that is not finished is continued")
      ->type_name("DIR")
      ->required();
  command.add_option("--methods", a.methods, "all, or some separated by commas")->delimiter(',')->capture_default_str();
  command.add_option("-j,--jobs", a.jobs, "visits at a time")->check(CLI::Range(1, 64))->capture_default_str();
  a.settings.add_options(command);
  command.add_flag("--quiet", a.quiet, "no progress, no table");
}

void add_chapter5(CLI::App& evaluate, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* const command = evaluate.add_subcommand("chapter5", "novel objects in full rooms: Table 5.2");
  command->add_option("DATASET", a->datasets, "folder of rooms in ObChange's layout, or one room")
      ->type_name("DIR")
      ->required()
      ->expected(1);
  add_common(*command, *a);
  command->callback([a, &exit_status] {
    a->settings.load();
    (void)chosen_methods(a->methods);
    exit_status = run(*a, "table52", {rooms_of("", a->datasets.front())});
  });
}

void add_reconstructions(CLI::App& evaluate, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  a->methods = {"local-verification"};
  CLI::App* const command =
      evaluate.add_subcommand("reconstructions", "the same over several reconstructions of the same rooms (5.3.6)");
  command->add_option("DATASETS", a->datasets, "NAME=DATASET: what the reconstruction is called, its folder of rooms")
      ->required();
  add_common(*command, *a);
  command->callback([a, &exit_status] {
    a->settings.load();
    (void)chosen_methods(a->methods);
    std::vector<JudgedRooms> judged;
    for (const std::string& word : a->datasets) judged.push_back(named_rooms(word, judged));
    exit_status = run(*a, "generality", std::move(judged));
  });
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& exit_status) {
  CLI::App* const evaluate = app.add_subcommand("evaluate", "what the methods of a chapter reach on a data set");
  evaluate->require_subcommand(1);
  add_chapter5(*evaluate, exit_status);
  add_reconstructions(*evaluate, exit_status);
}

}  // namespace amiss::app
