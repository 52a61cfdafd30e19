#include "experiment/figure.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "experiment/sample_results.hpp"

namespace amiss::experiment {
namespace {

Spec spec() {
  Spec s;
  s.worlds = {"lab_30", "flat_90"};
  s.methods = {"dynamic", "static"};
  s.objects = {1, 2};
  return s;
}

std::vector<TrialResult> results() {
  return {sample_result("dynamic", 1, {10.0, 20.0}, 2, 1.0), sample_result("dynamic", 2, {14.0, 24.0}, 2, 1.0),
          sample_result("static", 1, {30.0, 60.0}, 2, 6.0), sample_result("static", 2, {40.0}, 2, 6.0)};
}

FigureSpec figure(FigureSpec::Shows shows, std::vector<std::string> times = {}) {
  return {"fig", "A 'quoted' title", "lab_30", shows, std::move(times)};
}

/// Lines of a file that hold all these words.
std::vector<std::string> lines_with(const std::string& text, const std::vector<std::string>& words) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    bool all = true;
    for (const std::string& word : words) all = all && line.find(word) != std::string::npos;
    if (all) lines.push_back(line);
  }
  return lines;
}

TEST(Figure, IsNothingWithoutResults) {
  EXPECT_FALSE(figure_of(spec(), figure(FigureSpec::Shows::kSegmentations), {}).has_value());
  FigureSpec elsewhere = figure(FigureSpec::Shows::kSegmentations);
  elsewhere.world = "flat_90";
  EXPECT_FALSE(figure_of(spec(), elsewhere, results()).has_value());
}

TEST(Figure, OfSegmentationsHasAPointForEachTrialAndABoxForEachBatch) {
  const auto f = figure_of(spec(), figure(FigureSpec::Shows::kSegmentations), results());
  ASSERT_TRUE(f.has_value());
  const std::string &points = f->files.at("fig.tsv"), &boxes = f->files.at("fig_boxes.tsv");
  EXPECT_EQ(lines_with(points, {"dynamic"}).size(), 2U);
  EXPECT_EQ(lines_with(points, {"static"}).size(), 1U) << "what found not all has no place on the axis";
  ASSERT_EQ(lines_with(boxes, {"static"}).size(), 1U);
  EXPECT_NE(lines_with(boxes, {"static"})[0].find("1 of 2 not all"), std::string::npos) << "but it is counted";
  EXPECT_EQ(lines_with(boxes, {"dynamic"})[0], "dynamic\t0.8\t2\t2\t0\t2\t2\t2\t2\t2\t-");
}

TEST(Figure, OfTimesRecomputesThemAsTheThesisDoes) {
  const auto f = figure_of(spec(), figure(FigureSpec::Shows::kTime, {"simulation", "fast"}), results());
  ASSERT_TRUE(f.has_value());
  const auto boxes = lines_with(f->files.at("fig_boxes.tsv"), {"dynamic, "});
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_NE(boxes[0].find("dynamic, 1 s a segmentation\t0.7\t2\t2\t0\t20\t21\t22\t23\t24"), std::string::npos);
  EXPECT_NE(boxes[1].find("dynamic, 0.02 s a segmentation"), std::string::npos);
  EXPECT_NE(boxes[1].find("\t20.04\t"), std::string::npos) << "22 s - 2 actions of 1 s + 2 of 0.02 s";
}

TEST(Figure, WhiskersEndAtTheLastValueThatIsNear) {
  std::vector<TrialResult> many;
  const std::vector<double> ends{10, 11, 12, 13, 14, 15, 16, 100};
  for (std::size_t i = 0; i < ends.size(); ++i) many.push_back(sample_result("dynamic", i, {ends[i]}, 1, 1.0));
  const auto f = figure_of(spec(), figure(FigureSpec::Shows::kTime, {"simulation"}), many);
  EXPECT_EQ(lines_with(f->files.at("fig_boxes.tsv"), {"dynamic"})[0],
            "dynamic, 1 s a segmentation\t-0.2\t1\t8\t0\t10\t11.75\t13.5\t15.25\t16\t-");
}

TEST(Figure, OfObjectsFoundHasStepsOfMedianAndQuartiles) {
  const auto f = figure_of(spec(), figure(FigureSpec::Shows::kFound, {"simulation"}), results());
  ASSERT_TRUE(f.has_value());
  const auto steps = lines_with(f->files.at("fig.tsv"), {"2 objects, simulation\tdynamic"});
  ASSERT_EQ(steps.size(), 1U + 2U * 5U) << "the beginning, four finds and the end";
  EXPECT_EQ(steps[0], "2 objects, simulation\tdynamic\t0\t0\t0\t0");
  EXPECT_EQ(steps[2], "2 objects, simulation\tdynamic\t10\t0.25\t0.5\t0.75");
  EXPECT_EQ(steps.back(), "2 objects, simulation\tdynamic\t63\t2\t2\t2");
}

TEST(Figure, TitlesAreNoCommands) {
  FigureSpec evil = figure(FigureSpec::Shows::kSegmentations);
  evil.title = "it's `date`\nsystem('date')";
  const std::string script = figure_of(spec(), evil, results())->files.at("fig.gp");
  EXPECT_EQ(lines_with(script, {"set title"}), std::vector<std::string>{"set title 'it''s `date` system(''date'')'"});
}

}  // namespace
}  // namespace amiss::experiment
