#include "page/report_page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/result.hpp"
#include "page/bundle.hpp"
#include "page/run_files.hpp"
#include "page/small_run.hpp"

namespace amiss::page {
namespace {

using nlohmann::json;

/// What a browser would find in the script element.
json run_in(const std::string& html) {
  const std::string open = "<script type=\"application/json\" id=\"run\">";
  const std::size_t begin = html.find(open) + open.size();
  const std::string text = html.substr(begin, html.find("</script>", begin) - begin);
  EXPECT_EQ(text.find('<'), std::string::npos);
  return json::parse(text);
}

std::vector<json> frames_in(const json& run) {
  std::vector<json> frames;
  for (const json& event : run["events"]) {
    if (event["e"] == "frame") frames.push_back(event);
  }
  return frames;
}

ReportPage page_of(const std::vector<std::string>& lines, const std::filesystem::path& folder) {
  return {
      lines, [folder](Slice slice) { return load_picture(folder, slice); }, {{"params.yaml", "a: 1 # </script>\n"}}};
}

TEST(ReportPage, HoldsTheRunAndNeedsNothingElse) {
  test::TemporaryFolder folder;
  History history;
  test::SmallRun().record(folder.path(), history, 3.0);
  const std::string html = to_html(page_of(history.lines(), folder.path()));
  const json run = run_in(html);
  EXPECT_EQ(run["events"].front()["e"], "start");
  EXPECT_EQ(run["events"].back()["e"], "end");
  EXPECT_EQ(run["texts"]["params.yaml"], "a: 1 # </script>\n");
  EXPECT_EQ(run["pictures"].size(), 2 * frames_in(run).size()) << "colour and depth of each frame";
  EXPECT_EQ(run["pictures"].begin()->get<std::string>().rfind("data:image/jpeg;base64,/9j", 0), 0U);
  EXPECT_EQ(html.find("/app.js\""), std::string::npos);
  EXPECT_EQ(html.find("/app.css\""), std::string::npos);
  EXPECT_NE(html.find(bundled("/app.js")), std::string::npos);
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
}

TEST(ReportPage, ShowsTheCameraAllAlongTheRun) {
  test::TemporaryFolder folder;
  History history;
  test::SmallRun().record(folder.path(), history, 200.0);
  const json run = run_in(to_html(page_of(history.lines(), folder.path())));
  const std::vector<json> frames = frames_in(run);
  ASSERT_GT(frames.size(), kMostFrames / 2);
  EXPECT_LE(frames.size(), kMostFrames);
  EXPECT_LT(frames.front()["t"].get<double>(), 10.0);
  EXPECT_GT(frames.back()["t"].get<double>(), 198.0);
  for (const json& frame : frames) {
    for (const char* key : {"colour", "depth"}) {
      EXPECT_TRUE(run["pictures"].contains(std::to_string(frame[key].at(0).get<std::size_t>()))) << frame;
    }
  }
}

/// Differences of 40 kB each: more than there is room for.
TEST(ReportPage, KeepsOfManyWhatFitsEvenlyAndTheLast) {
  std::vector<std::string> lines;
  for (int i = 0; i < 100; ++i) {
    lines.push_back(json{{"e", "difference"}, {"t", i}, {"appeared", std::string(40'000, 'A')}}.dump());
  }
  const json run = run_in(to_html({lines, {}, {}}));
  ASSERT_GE(run["events"].size(), 5U);
  EXPECT_LE(run["events"].dump().size(), kMostOfAKind + 100);
  EXPECT_EQ(run["events"].back()["t"], 99);
  EXPECT_LT(run["events"].front()["t"], 25);
}

/// Pictures of 90 kB: the last frame and the examination come first, and no frame stays that could not be shown.
TEST(ReportPage, TheLastPicturesAndExaminationsComeFirst) {
  std::vector<std::string> lines;
  for (int i = 0; i < 20; ++i) {
    const json colour{200'000 * i, 45'000}, depth{200'000 * i + 100'000, 45'000};
    lines.push_back(json{{"e", "frame"}, {"t", i}, {"colour", colour}, {"depth", depth}}.dump());
  }
  lines.insert(lines.begin() + 1, json{{"e", "examined"}, {"t", 0.5}, {"picture", {7, 90'000}}}.dump());
  const json run = run_in(to_html({lines, [](Slice slice) { return std::string(slice.bytes, 'x'); }, {}}));
  EXPECT_TRUE(run["pictures"].contains("7"));
  EXPECT_TRUE(run["pictures"].contains("3800000"));
  EXPECT_EQ(frames_in(run).size(), 6U);
  EXPECT_EQ(run["pictures"].size(), 13U);
}

TEST(ReportPage, NoTextOfARunCanEndItsElement) {
  test::TemporaryFolder folder;
  History history;
  test::SmallRun run;
  run.objects[0].name = "</script><script>alert(1)</script>";
  run.record(folder.path(), history, 1.0);
  const std::string html = to_html(page_of(history.lines(), folder.path()));
  EXPECT_EQ(html.find("alert(1)</script>"), std::string::npos);
  EXPECT_NE(run_in(html).dump().find("alert(1)"), std::string::npos);
}

TEST(ReportPage, LongRunsStaySmall) {
  test::TemporaryFolder folder;
  History history;
  test::SmallRun run;
  run.during = [&](mission::Sinks& sinks, int i) {
    const int n = i % 50;
    for (int k = 0; n == 0 && k < 60; ++k) run.current.set({i / 50, k, 3 + (i / 50) % 7}, Occupancy::kOccupied);
    if (i % 100 == 0) sinks.log(run.now, std::string(9000, 'x'));
  };
  run.record(folder.path(), history, 600.0);
  std::size_t whole = 0;
  for (const std::string& line : history.lines()) whole += line.size();
  EXPECT_GT(whole, 3'000'000U);
  const std::string html = to_html(page_of(history.lines(), folder.path()));
  EXPECT_LT(html.size(), 3'000'000U);
  const json report = run_in(html);
  std::size_t poses = 0;
  std::string voxels;
  for (const json& event : report["events"]) {
    poses += event["e"] == "pose" ? 1U : 0U;
    if (event["e"] == "voxels") voxels += event["on"].get<std::string>();
  }
  EXPECT_LE(poses, kMostPoses + 1);
  EXPECT_GT(poses, kMostPoses / 2);
  EXPECT_EQ(voxels.size(), 600U * 60U * 8U) << "every voxel that is occupied at the end, once";
}

TEST(ReportPage, RefusesWhatIsNoTimeline) {
  EXPECT_THROW((void)to_html({{"rubbish"}, {}, {}}), InputError);
  EXPECT_THROW((void)to_html({{"{\"t\":1}"}, {}, {}}), InputError);
}

}  // namespace
}  // namespace amiss::page
