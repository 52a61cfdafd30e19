#include "report_figure.hpp"

#include <cstdlib>
#include <sstream>

#include "apps/program.hpp"
#include "dataset_report.hpp"
#include "evaluate_figure.hpp"

namespace amiss::app {
namespace {

namespace fs = std::filesystem;

const experiment::Table kTable{
    {"room", "method", "precision", "precision_sd", "recall", "recall_sd", "f1", "f1_sd", "missed", "wrong"},
    {{"office", "octomap", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "7", "8"},
     {"average", "octomap", "0.11", "0.21", "0.31", "0.41", "0.51", "0.61", "7", "8"},
     {"average", "semantic", "0.9", "0.01", "0.8", "0.02", "0.7", "0.03", "1", "2"}}};

bool has_gnuplot() { return std::system("command -v gnuplot >/dev/null") == 0; }

TEST(AveragesFigure, TakesTheAverages) {
  const experiment::Figure figure = averages_figure(kTable, "averages");
  EXPECT_EQ(figure.files.at("averages.tsv"),
            "bars\tprecision\tprecision_sd\trecall\trecall_sd\tf1\tf1_sd\n"
            "octomap\t0.11\t0.21\t0.31\t0.41\t0.51\t0.61\n"
            "semantic\t0.9\t0.01\t0.8\t0.02\t0.7\t0.03\n");
}

TEST(AveragesFigure, TellsReconstructionsApart) {
  experiment::Table table = kTable;
  table.heading.insert(table.heading.begin() + 1, "reconstruction");
  for (auto& row : table.rows) row.insert(row.begin() + 1, "fine");
  EXPECT_NE(averages_figure(table, "a").files.at("a.tsv").find("\nfine, semantic\t0.9\t"), std::string::npos);
}

TEST(ReportFigure, IsDrawnIntoThePageAndKeptBesideIt) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  const test::TemporaryFolder folder;
  report::Document page("Test");
  add_figure(page, averages_figure(kTable, "averages"), folder.path());
  EXPECT_NE(page.to_html().find("<figure id=\"averages\"><svg"), std::string::npos);
  EXPECT_NE(page.to_html().find("semantic"), std::string::npos);
  for (const char* file : {"averages.tsv", "averages.gp", "averages.svg", "averages.pdf", "averages.png"}) {
    EXPECT_TRUE(fs::exists(folder.path() / "figures" / file)) << file;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "figures"), {}), 5) << "nothing is left over";
}

TEST(ReportFigure, ThePageSaysWhyThereIsNone) {
  const test::TemporaryFolder folder;
  fs::create_symlink("/usr/bin/env", folder.path() / "env");
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  report::Document page("Test");
  add_figure(page, averages_figure(kTable, "averages"), folder.path());
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(page.to_html().find("<svg"), std::string::npos);
  EXPECT_NE(page.to_html().find("(figures/averages.tsv, averages.gp): not drawn. gnuplot: is not installed"),
            std::string::npos)
      << page.to_html();
  EXPECT_TRUE(fs::exists(folder.path() / "figures" / "averages.gp")) << "to be drawn elsewhere";
}

TEST(DatasetReport, ShowsObjectsAndErrorsOfEachVisit) {
  const test::TemporaryFolder folder;
  std::vector<fs::path> recordings;
  for (const int scene : {1, 2}) {
    recordings.push_back(folder.path() / "recordings" / "office" / ("scene" + std::to_string(scene)));
    fs::create_directories(recordings.back() / "rgb");
    fs::create_directories(recordings.back() / "truth");
    std::ofstream(recordings.back() / "recording.json")
        << R"({"room":"office","scene":"scene)" << scene
        << R"(","frames":9,"waypoints":5,"reached":5,"distance_m":4.7,"simulated_s":82.9,"collisions":0,)"
        << R"("localization":{"rmse_m":0.0125}})";
    std::ofstream(recordings.back() / "truth" / "objects.yaml")
        << (scene == 1 ? "[]\n" : "- {object: 'mug'}\n- {object: 'book'}\n");
  }
  save_dataset_report(folder.path(), "2 recordings", "seed: 1\n", recordings);
  EXPECT_EQ(folder.read("figures/visits.tsv"),
            "visit\tobjects\terror_mm\noffice scene1\t0\t12.50\noffice scene2\t2\t12.50\n");
  const std::string page = folder.read("report.html");
  EXPECT_NE(page.find("<td>scene2</td><td>2</td><td>9</td>"), std::string::npos);
  EXPECT_NE(page.find("Eigen 3."), std::string::npos) << "versions";
  EXPECT_EQ(page.find("<svg") != std::string::npos, has_gnuplot());
}

}  // namespace
}  // namespace amiss::app
