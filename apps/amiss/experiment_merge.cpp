#include "experiment_merge.hpp"

#include <fmt/format.h>

#include <iostream>

#include "commands.hpp"
#include "experiment/merge.hpp"
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

int verify_experiment(const std::filesystem::path& path) {
  const experiment::Verified verified = experiment::verify(path);
  for (const std::string& sentence : verified.wrong) std::cout << sentence << "\n";
  std::cout << fmt::format(
      "{} trials planned, {} results ({} of failed trials): {}\n", verified.planned, verified.results, verified.failed,
      verified.wrong.empty() ? "all is right" : fmt::format("{} things are wrong", verified.wrong.size()));
  return verified.wrong.empty() ? kGoalMet : kGoalNotMet;
}

}  // namespace amiss::app
