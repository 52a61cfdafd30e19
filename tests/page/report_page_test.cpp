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
  EXPECT_EQ(run["pictures"].size(), 2U) << "colour and depth of the last frame";
  EXPECT_EQ(run["pictures"].begin()->get<std::string>().rfind("data:image/jpeg;base64,/9j", 0), 0U);
  EXPECT_EQ(html.find("/app.js\""), std::string::npos);
  EXPECT_EQ(html.find("/app.css\""), std::string::npos);
  EXPECT_NE(html.find(bundled("/app.js")), std::string::npos);
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
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
