#include "experiment/verify.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "experiment/merge.hpp"
#include "experiment/sample_report.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

struct Verify : testing::Test {
  test::TemporaryFolder folder;
  fs::path spec_file =
      folder.write("e.yaml", "name: test\nworlds: [lab_30]\nmethods: [static]\nobjects: [2]\nruns: 3\n");
  std::map<std::string, std::string> keys{{"lab_30", "key"}};
  std::vector<Trial> trials = trials_of(load_spec(spec_file), keys, "program");
  Folder out = Folder::begin(folder.path() / "out", spec_file, trials);

  Verify() {
    out.save_basis(keys);
    for (const Trial& t : trials) out.save_result(t, text_of(t), "");
    for (const auto& [name, bytes] : merged_files(out)) out.save(name, bytes);
  }
  static std::string text_of(const Trial& trial) { return result_text(trial, report::to_json(sample_report(), "")); }
  /// The one thing that is wrong.
  [[nodiscard]] std::string wrong() const {
    const Verified verified = verify(out.path());
    EXPECT_EQ(verified.wrong.size(), 1U) << testing::PrintToString(verified.wrong);
    return verified.wrong.empty() ? "" : verified.wrong[0];
  }
  void expect_wrong(const std::string& words) const {
    const std::string sentence = wrong();
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  }
};

TEST_F(Verify, AWholeFolderIsRight) {
  const Verified verified = verify(out.path());
  EXPECT_TRUE(verified.wrong.empty()) << verified.wrong[0];
  EXPECT_EQ(verified.planned, 3U);
  EXPECT_EQ(verified.results, 3U);
  EXPECT_EQ(verified.failed, 0U);
}

TEST_F(Verify, FailedTrialsAreCounted) {
  out.save_result(trials[0], failure_text(trials[0], "ended by signal 11"), "");
  for (const auto& [name, bytes] : merged_files(out)) out.save(name, bytes);
  EXPECT_EQ(verify(out.path()).failed, 1U);
  EXPECT_TRUE(verify(out.path()).wrong.empty());
}

TEST_F(Verify, MissingResultsAndStaleTablesAreWrong) {
  fs::remove(out.result_file(trials[1]));
  const Verified verified = verify(out.path());
  EXPECT_EQ(verified.results, 2U);
  ASSERT_GE(verified.wrong.size(), 2U);
  EXPECT_EQ(verified.wrong[0], trials[1].id + " (lab_30, static, 2 objects, seed 2): has no result");
  EXPECT_NE(verified.wrong[1].find("results.tsv: is not what merging gives now"), std::string::npos);
}

TEST_F(Verify, DoubledAndForeignResultsAreWrong) {
  out.save("trials/copy.json", text_of(trials[2]));
  expect_wrong("copy.json: is another result of " + trials[2].id);
  out.save("trials/copy.json", "{}");
  expect_wrong("copy.json: belongs to no planned trial");
  fs::remove(out.path() / "trials" / "copy.json");
  out.save_result(trials[0], text_of(trials[1]), "");
  expect_wrong(trials[0].id + ".json: is the result of another trial");
}

TEST_F(Verify, ChangedResultsAreWrong) {
  std::string text = text_of(trials[0]);
  text.replace(text.find("\"segmentation_actions\": 8"), 25, "\"segmentation_actions\": 7");
  out.save_result(trials[0], text, "");
  expect_wrong("was changed since it was written");
  out.save_result(trials[0], text.substr(0, 100), "");
  expect_wrong("is no result of a trial");
}

TEST_F(Verify, MixedProgramsAreRefused) {
  Trial newer = trials[0];
  newer.program = "newer";
  out.save_result(trials[0], text_of(newer), "");
  expect_wrong("comes from another program (newer) than the plan's (program)");
  trials[0].program = "newer";
  out.save("plan.tsv", to_tsv(trials));
  EXPECT_NE(verify(out.path()).wrong[0].find("trials of 2 programs (newer, program)"), std::string::npos);
}

TEST_F(Verify, ThePlanFollowsFromSpecAndBasis) {
  out.save_basis({{"lab_30", "another world"}});
  expect_wrong("plan.tsv: does not follow from experiment.yaml and basis/");
  fs::remove_all(out.path() / "basis");
  expect_wrong("there is no such file");
  out.save_basis(keys);
  trials.push_back(trials[0]);
  out.save("plan.tsv", to_tsv(trials));
  EXPECT_NE(verify(out.path()).wrong[0].find("stands in it twice"), std::string::npos);
  EXPECT_THROW((void)verify(folder.path()), InputError);
}

}  // namespace
}  // namespace amiss::experiment
