#include "report/run_folder.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::report {
namespace {

namespace fs = std::filesystem;
using test::sentence_of;
using test::TemporaryFolder;

TEST(RunFolder, RunsAndFinishes) {
  const TemporaryFolder top;
  const fs::path path = top.path() / "a" / "b";
  const RunFolder folder(path);
  EXPECT_EQ(top.read("a/b/status"), "running\n");
  EXPECT_FALSE(fs::exists(path / "report.json"));
  folder.save("plans/plan_1.txt", "(go)\n");
  folder.finish("{}\n");
  EXPECT_EQ(top.read("a/b/status"), "finished\n");
  EXPECT_EQ(top.read("a/b/report.json"), "{}\n");
  EXPECT_EQ(top.read("a/b/plans/plan_1.txt"), "(go)\n");
}

TEST(RunFolder, InterruptedHasNoReport) {
  const TemporaryFolder top;
  RunFolder(top.path() / "run").interrupt("{}\n");
  EXPECT_EQ(top.read("run/status"), "interrupted\n");
  EXPECT_FALSE(fs::exists(top.path() / "run" / "report.json"));
  EXPECT_EQ(top.read("run/report.partial.json"), "{}\n");
}

TEST(RunFolder, UnfinishedRunsAreReplaced) {
  const TemporaryFolder top;
  for (const bool interrupted : {false, true}) {
    const RunFolder folder(top.path() / "run");
    folder.save("log.txt", "x");
    folder.save("objects/mug.png", "x");
    if (interrupted) folder.interrupt("{}");
  }
  const RunFolder again(top.path() / "run");
  EXPECT_EQ(std::distance(fs::directory_iterator(again.path()), fs::directory_iterator()), 1) << "status alone";
}

TEST(RunFolder, FinishedRunsAndOtherFoldersAreNotTouched) {
  const TemporaryFolder top;
  RunFolder(top.path() / "run").finish("{}");
  EXPECT_NE(sentence_of<ArgumentError>([&] { RunFolder again(top.path() / "run"); }).find("holds something else"),
            std::string::npos);
  fs::create_directory(top.path() / "photos");
  top.write("photos/holiday.jpg", "dear");
  EXPECT_THROW(RunFolder(top.path() / "photos"), ArgumentError);
  EXPECT_EQ(top.read("photos/holiday.jpg"), "dear");
  top.write("file", "dear");
  EXPECT_THROW(RunFolder(top.path() / "file"), ArgumentError);
  EXPECT_THROW(RunFolder(top.path() / "file" / "below"), ArgumentError);
  EXPECT_EQ(top.read("file"), "dear");
}

TEST(RunFolder, EmptyFoldersAreTaken) {
  const TemporaryFolder top;
  const RunFolder folder(top.path());
  EXPECT_EQ(top.read("status"), "running\n");
}

TEST(RunFolder, UnusedNamesCountOn) {
  const TemporaryFolder top;
  EXPECT_EQ(unused_folder(top.path(), "run"), top.path() / "run");
  fs::create_directory(top.path() / "run");
  EXPECT_EQ(unused_folder(top.path(), "run"), top.path() / "run-2");
  fs::create_directory(top.path() / "run-2");
  EXPECT_EQ(unused_folder(top.path(), "run"), top.path() / "run-3");
}

}  // namespace
}  // namespace amiss::report
