#include "experiment/folder.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "experiment/sample_report.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

struct ExperimentFolder : testing::Test {
  test::TemporaryFolder folder;
  fs::path spec_file = folder.write(
      "e.yaml", "name: test\nworlds: [lab_30]\nmethods: [static]\nobjects: [2]\nruns: 3\nscatter_seed: 100\n");
  std::vector<Trial> trials = trials_of(load_spec(spec_file), {{"lab_30", "key"}}, "program");
  fs::path out = folder.path() / "out";
  std::string report = report::to_json(sample_report(), "");

  void save(const Folder& to, const Trial& trial) const {
    to.save_result(trial, result_text(trial, report), times_text(report));
  }
};

TEST_F(ExperimentFolder, KnowsWhatIsMissing) {
  const Folder begun = Folder::begin(out, spec_file, trials);
  EXPECT_EQ(begun.missing(), trials);
  save(begun, trials[1]);
  EXPECT_EQ(begun.missing(), (std::vector<Trial>{trials[0], trials[2]}));
  const Folder again = Folder::begin(out, spec_file, trials);
  EXPECT_EQ(again.missing().size(), 2U);
  const Folder opened = Folder::open(out);
  EXPECT_EQ(opened.trials(), trials);
  ASSERT_EQ(opened.results().size(), 1U);
  EXPECT_EQ(opened.results()[0].segmentations, 8);
  EXPECT_DOUBLE_EQ(opened.times(trials[1])->wall_s, 4.0);
  EXPECT_FALSE(opened.times(trials[0]).has_value());
  EXPECT_EQ(opened.trial(trials[2].id), trials[2]);
  EXPECT_THROW((void)opened.trial("nobody"), ArgumentError);
}

TEST_F(ExperimentFolder, FailuresStayUntilTheyAreForgotten) {
  const Folder begun = Folder::begin(out, spec_file, trials);
  save(begun, trials[0]);
  begun.save_result(trials[1], failure_text(trials[1], "ended by signal 11"), "");
  EXPECT_EQ(begun.missing().size(), 1U);
  EXPECT_EQ(begun.results().size(), 2U) << "never dropped";
  begun.forget_failures();
  EXPECT_EQ(begun.missing().size(), 2U);
}

TEST_F(ExperimentFolder, OtherFoldersAreRefused) {
  (void)Folder::begin(out, spec_file, trials);
  const auto others = trials_of(load_spec(spec_file), {{"lab_30", "another world"}}, "program");
  EXPECT_NE(test::sentence_of<ArgumentError>([&] {
              (void)Folder::begin(out, spec_file, others);
            }).find("holds another experiment"),
            std::string::npos);
  const auto newer = trials_of(load_spec(spec_file), {{"lab_30", "key"}}, "newer");
  EXPECT_NE(test::sentence_of<ArgumentError>([&] {
              (void)Folder::begin(out, spec_file, newer);
            }).find("results of another program (program; this one is newer)"),
            std::string::npos);
  EXPECT_THROW((void)Folder::begin(folder.path(), spec_file, trials), ArgumentError) << "there is a file in it";
  EXPECT_THROW((void)Folder::begin(spec_file, spec_file, trials), ArgumentError) << "is a file";
  EXPECT_THROW((void)Folder::open(folder.path()), InputError);
}

TEST_F(ExperimentFolder, IsForOneProgram) {
  const Folder begun = Folder::begin(out, spec_file, trials);
  EXPECT_NO_THROW(begun.require_program("program"));
  EXPECT_THROW(begun.require_program("newer"), ArgumentError);
}

TEST_F(ExperimentFolder, KeepsWhatTheIdsStandFor) {
  const Folder begun = Folder::begin(out, spec_file, trials);
  EXPECT_THROW((void)begun.basis(), InputError) << "not there yet";
  const std::map<std::string, std::string> keys{{"lab_30", "key"}};
  begun.save_basis(keys);
  EXPECT_EQ(Folder::open(out).basis(), keys);
}

TEST_F(ExperimentFolder, WorkIsClearedAway) {
  const Folder begun = Folder::begin(out, spec_file, trials);
  const fs::path work = begun.work_folder(trials[0]);
  EXPECT_FALSE(fs::exists(work));
  fs::create_directories(work / "plans");
  begun.clear_work();
  EXPECT_TRUE(fs::is_empty(out / "work"));
  begun.save("figures/a.tsv", "x");
  EXPECT_EQ(folder.read("out/figures/a.tsv"), "x");
}

}  // namespace
}  // namespace amiss::experiment
