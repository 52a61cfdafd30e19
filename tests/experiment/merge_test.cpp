#include "experiment/merge.hpp"

#include <gtest/gtest.h>

#include "core/temporary_folder.hpp"
#include "experiment/sample_report.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

struct Merge : testing::Test {
  test::TemporaryFolder folder;
  fs::path spec_file =
      folder.write("e.yaml", "name: test\nworlds: [lab_30]\nmethods: [dynamic, static]\nobjects: [2]\nruns: 2\n");
  std::vector<Trial> trials = trials_of(load_spec(spec_file), {{"lab_30", "key"}}, "program");
  Folder begin(const std::string& name) const { return Folder::begin(folder.path() / name, spec_file, trials); }
  static void save(const Folder& to, const Trial& trial, double wall_s) {
    report::TidyReport report = sample_report();
    report.method = trial.method;
    report.wall_s = wall_s;
    const std::string json = report::to_json(report, "");
    to.save_result(trial, result_text(trial, json), times_text(json));
  }
};

TEST_F(Merge, HasALineForEachTrialWhateverBecameOfIt) {
  const Folder out = begin("out");
  save(out, trials[0], 3.0);
  out.save_result(trials[1], failure_text(trials[1], "status 3: no\tsuch world"), "");
  const Table table = results_table(trials, out.results());
  ASSERT_EQ(table.rows.size(), 4U);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.heading.size());
  EXPECT_EQ(table.rows[0][7], "done");
  EXPECT_EQ(table.rows[1][7], "failed");
  EXPECT_EQ(table.rows[1].back(), "status 3: no\tsuch world");
  EXPECT_EQ(table.rows[2][7], "missing");
  EXPECT_NE(to_tsv(table).find("\tstatus 3: no such world\n"), std::string::npos);
  ASSERT_EQ(clock_table(out).rows.size(), 1U);
  EXPECT_EQ(clock_table(out).rows[0][1], "3");
}

TEST_F(Merge, IsTheSameInWhateverOrderAndHoweverFastTheTrialsWere) {
  const Folder forth = begin("forth"), back = begin("back");
  for (std::size_t i = 0; i < trials.size(); ++i) {
    save(forth, trials[i], 1.0);
    save(back, trials[trials.size() - 1 - i], 100.0);
  }
  EXPECT_EQ(merged_files(forth), merged_files(back));
  EXPECT_NE(clock_table(forth).rows, clock_table(back).rows);
  EXPECT_EQ(merged_files(forth).size(), 3U);
}

}  // namespace
}  // namespace amiss::experiment
