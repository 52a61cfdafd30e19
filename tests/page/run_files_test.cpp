#include "page/run_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/result.hpp"
#include "page/small_run.hpp"

namespace amiss::page {
namespace {

TEST(RunFiles, ReadWhatARecorderLeft) {
  test::TemporaryFolder folder;
  History history;
  test::SmallRun().record(folder.path(), history, 2.0);
  EXPECT_EQ(load_timeline(folder.path()), history.lines());
  EXPECT_EQ(load_picture(folder.path(), {0, 2}), "\xff\xd8");
  EXPECT_THROW((void)load_picture(folder.path(), {0, folder.read("camera.bin").size() + 1}), InputError);
  EXPECT_THROW((void)load_picture(folder.path(), {~std::size_t{0}, 2}), InputError);
  std::filesystem::remove(folder.path() / "camera.bin");
  const std::string said = test::sentence_of<InputError>([&] { (void)load_picture(folder.path(), {0, 2}); });
  EXPECT_NE(said.find("camera.bin: is not there"), std::string::npos) << said;
}

TEST(RunFiles, ARunThatWasKilledLosesItsLastLineOnly) {
  test::TemporaryFolder folder;
  folder.write("timeline.jsonl", "{\"e\":\"start\",\"t\":0,\"schema\":1}\n{\"e\":\"pose\",\"t\":1}\n{\"e\":\"po");
  EXPECT_EQ(load_timeline(folder.path()).size(), 2U);
}

TEST(RunFiles, SayWhatIsWrong) {
  test::TemporaryFolder folder;
  const auto sentence = [&] { return test::sentence_of<InputError>([&] { (void)load_timeline(folder.path()); }); };
  EXPECT_NE(sentence().find("timeline.jsonl: is not there"), std::string::npos);
  const std::string start = "{\"e\":\"start\",\"t\":0,\"schema\":1}\n";
  for (const char* line :
       {"rubbish", "[]", "{\"e\":1,\"t\":0}", "{\"e\":\"pose\"}", "{\"e\":\"pose\",\"t\":\"1\"}", ""}) {
    folder.write("timeline.jsonl", start + line + "\n");
    EXPECT_NE(sentence().find("timeline.jsonl:2: is no event"), std::string::npos) << line;
  }
  folder.write("timeline.jsonl", "{\"e\":\"start\",\"t\":0,\"schema\":99}\n");
  EXPECT_NE(sentence().find("schema 1"), std::string::npos);
  folder.write("timeline.jsonl", "");
  EXPECT_NE(sentence().find("beginning of a run"), std::string::npos);
}

TEST(RunFiles, AStoryNamesTheFileThatIsNone) {
  test::TemporaryFolder folder;
  folder.write("timeline.jsonl", "{\"e\":\"start\",\"t\":0,\"schema\":1}\n");
  const std::string said = test::sentence_of<InputError>([&] { (void)load_story(folder.path()); });
  EXPECT_EQ(said.find((folder.path() / "timeline.jsonl:1: ").string()), 0U) << said;
  EXPECT_NE(said.find("a newer run is needed"), std::string::npos) << said;
}

TEST(RunFiles, ServeNothingButWhatIsNamed) {
  const auto files = served_files("run");
  EXPECT_EQ(files.size(), 5U);
  for (const ServedFile& file : files) EXPECT_EQ(file.route, "/" + file.file.filename().string());
  EXPECT_TRUE(std::none_of(files.begin(), files.end(), [](const auto& f) { return f.route == "/knowledge.sqlite"; }));
}

}  // namespace
}  // namespace amiss::page
