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

/// Pictures of 450 kB: the last frame and the examination come first, and no frame stays that could not be shown.
TEST(ReportPage, TheLastPicturesAndExaminationsComeFirst) {
  std::vector<std::string> lines;
  for (int i = 0; i < 20; ++i) {
    const json colour{1'000'000 * i, 225'000}, depth{1'000'000 * i + 500'000, 225'000};
    lines.push_back(json{{"e", "frame"}, {"t", i}, {"colour", colour}, {"depth", depth}}.dump());
  }
  lines.insert(lines.begin() + 1, json{{"e", "examined"}, {"t", 0.5}, {"picture", {7, 450'000}}}.dump());
  const std::string html = to_html({lines, [](Slice slice) { return std::string(slice.bytes, 'x'); }, {}});
  const json run = run_in(html);
  EXPECT_TRUE(run["pictures"].contains("7"));
  EXPECT_TRUE(run["pictures"].contains("19000000"));
  EXPECT_EQ(run["pictures"].size(), 1 + 2 * frames_in(run).size());
  EXPECT_LT(html.size(), kMostBytes);
  EXPECT_GT(html.size(), kMostBytes - 601'000) << "one more would have fitted";
  EXPECT_LE(frames_in(run).front()["t"], 10) << "what is left is spread over the run";
}

TEST(ReportPage, NamesTheLibrariesBesideTheProgram) {
  test::TemporaryFolder folder;
  History history;
  test::SmallRun().record(folder.path(), history, 1.0);
  ReportPage page = page_of(history.lines(), folder.path());
  EXPECT_EQ(run_in(to_html(page))["events"][0]["version"], "0.0.0");
  page.libraries = "Eigen 3.4.0, MRPT 2.5.8";
  EXPECT_EQ(run_in(to_html(page))["events"][0]["version"], "0.0.0; Eigen 3.4.0, MRPT 2.5.8");
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
    if (event["e"] != "voxels") continue;
    voxels += event["on"].get<std::string>();
    EXPECT_TRUE(event["merged"]);
  }
  EXPECT_LE(poses, kMostPoses + 1);
  EXPECT_GT(poses, kMostPoses / 2);
  EXPECT_EQ(voxels.size(), 600U * 60U * 8U) << "every voxel that is occupied at the end, once";
}

std::string layer(int z, int count) {
  std::vector<mapping::Voxel> voxels;
  for (int i = 0; i < count; ++i) voxels.push_back({i % 200, i / 200, z});
  return voxels_text(voxels);
}

/// More of everything than a flat has: every kind beyond its bounds, a map of a large building, 20 kB a picture.
TEST(ReportPage, IsSmallForAnyRun) {
  std::string building;
  for (int z = 0; z < 150; ++z) building += layer(z, 2000);
  std::vector<std::string> lines{json{{"e", "start"}, {"t", 0}, {"version", "0"}, {"reference", building}}.dump()};
  for (int i = 1; i <= 200; ++i) {
    for (const char* kind : {"regions", "views", "plan", "objects", "path", "log", "bodies", "script", "step", "pose",
                             "progress", "collision"}) {
      lines.push_back(json{{"e", kind}, {"t", i}, {"what", std::string(500, '<')}}.dump());
    }
    lines.push_back(json{{"e", "voxels"}, {"t", i}, {"on", layer(i % 50, 1000)}, {"off", ""}}.dump());
    lines.push_back(json{{"e", "examined"}, {"t", i}, {"picture", {40'000 * i + 20'000, 20'000}}}.dump());
    const json colour{40'000 * i, 10'000}, depth{40'000 * i + 10'000, 10'000};
    lines.push_back(json{{"e", "frame"}, {"t", i}, {"colour", colour}, {"depth", depth}}.dump());
  }
  lines.push_back(json{{"e", "difference"}, {"t", 199}, {"appeared", building}, {"vanished", building}}.dump());
  const json touches(20'000, json{{"link", "base"}, {"body", "wall"}});
  lines.push_back(json{{"e", "end"}, {"t", 200}, {"report", {{"collision_list", touches}, {"found", 5}}}}.dump());
  const std::string html = to_html({lines, [](Slice slice) { return std::string(slice.bytes, 'x'); }, {}});
  EXPECT_LT(html.size(), kMostBytes);
  EXPECT_GT(html.size(), kMostBytes - kLeastForPictures) << "room is left";
  const json run = run_in(html);
  EXPECT_EQ(run["events"].back()["report"]["found"], 5);
  EXPECT_FALSE(frames_in(run).empty());
  const std::string reference = run["events"].front()["reference"];
  ASSERT_GT(reference.size(), 0U);
  EXPECT_EQ(building.compare(0, reference.size(), reference), 0) << "the lower layers, each whole";
  EXPECT_NE(run["events"].dump().find("maps without their upper layers"), std::string::npos);
}

TEST(ReportPage, RefusesWhatIsNoTimeline) {
  EXPECT_THROW((void)to_html({{"rubbish"}, {}, {}}), InputError);
  EXPECT_THROW((void)to_html({{"{\"t\":1}"}, {}, {}}), InputError);
}

}  // namespace
}  // namespace amiss::page
