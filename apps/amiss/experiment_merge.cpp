#include "experiment_merge.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "commands.hpp"
#include "experiment/gnuplot.hpp"
#include "experiment/merge.hpp"
#include "experiment/page.hpp"
#include "experiment/summary.hpp"
#include "experiment/verify.hpp"

namespace amiss::app {

int merge_experiment(const std::filesystem::path& path) {
  const experiment::Folder folder = experiment::Folder::open(path);
  for (const auto& [name, bytes] : experiment::merged_files(folder)) folder.save(name, bytes);
  folder.save("clock.tsv", to_tsv(experiment::clock_table(folder)));
  const auto results = folder.results();
  std::cout << to_columns(experiment::short_summary(folder.trials(), results)) << "\n"
            << to_columns(experiment::short_statistics(folder.spec(), results));
  std::size_t failed = 0;
  for (const experiment::TrialResult& result : results) failed += result.failed ? 1U : 0U;
  const std::size_t missing = folder.trials().size() - results.size();
  if (failed + missing == 0) return kGoalMet;
  std::cerr << fmt::format("amiss: {}: of {} trials {} failed and {} are missing\n", path.string(),
                           folder.trials().size(), failed, missing);
  return kGoalNotMet;
}

int plot_experiment(const std::filesystem::path& path) {
  const experiment::Folder folder = experiment::Folder::open(path);
  const auto results = folder.results();
  const std::filesystem::path figures = "figures";
  std::vector<experiment::Figure> all;
  for (const experiment::FigureSpec& spec : folder.spec().figures) {
    const auto figure = figure_of(folder.spec(), spec, results);
    if (!figure) {
      std::cerr << fmt::format("amiss: {}: no trial in {} has a result yet\n", spec.name, spec.world);
      continue;
    }
    for (const auto& [name, bytes] : figure->files) folder.save(figures / name, bytes);
    all.push_back(*figure);
  }
  std::vector<experiment::DrawnFigure> drawn;
  for (const experiment::Figure& figure : all) {
    const auto scratch = folder.path() / "work" / fmt::format("{}.{}", figure.name, ::getpid());
    const auto pictures = experiment::drawn(figure, scratch);
    for (const auto& [name, bytes] : pictures) folder.save(figures / name, bytes);
    drawn.push_back({figure.name, figure.title, pictures.at(figure.name + ".svg")});
  }
  folder.save("report.html", to_html(folder, drawn));
  std::cout << (folder.path() / "report.html").string() << "\n";
  return kGoalMet;
}

int verify_experiment(const std::filesystem::path& path) {
  const experiment::Verified verified = experiment::verify(path);
  for (const std::string& sentence : verified.wrong) std::cout << sentence << "\n";
  std::cout << fmt::format(
      "{} trials planned, {} results ({} of failed trials): {}\n", verified.planned, verified.results, verified.failed,
      verified.wrong.empty() ? "all is right" : fmt::format("{} things are wrong", verified.wrong.size()));
  return verified.wrong.empty() ? kGoalMet : kGoalNotMet;
}

}  // namespace amiss::app
