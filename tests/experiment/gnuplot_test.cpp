#include "experiment/gnuplot.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "experiment/process.hpp"
#include "experiment/sample_results.hpp"

namespace amiss::experiment {
namespace {

bool has_gnuplot() {
  return run_program({"sh", "-c", "command -v gnuplot"}, "", [] { return false; }).status == 0;
}

struct Gnuplot : testing::TestWithParam<FigureSpec::Shows> {
  test::TemporaryFolder folder;
  [[nodiscard]] static Figure figure(FigureSpec::Shows shows) {
    Spec spec;
    spec.methods = {"dynamic", "static"};
    spec.objects = {1, 2};
    return *figure_of(spec, {"fig", "A `title` of 'it'", "lab_30", shows, {"real_robot", "fast"}},
                      {sample_result("dynamic", 1, {10.0, 20.0}, 2, 1.0), sample_result("static", 1, {30.0}, 2, 6.0),
                       sample_result("static", 2, {30.0, 60.0}, 2, 6.0)});
  }
};

TEST_P(Gnuplot, DrawsTheSameBytesAtAnyTime) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  const auto scratch = folder.path() / "scratch";
  const auto pictures = drawn(figure(GetParam()), scratch);
  ASSERT_EQ(pictures.size(), 3U);
  EXPECT_EQ(pictures.at("fig.pdf").substr(0, 5), "%PDF-");
  EXPECT_EQ(pictures.at("fig.png").substr(1, 3), "PNG");
  const std::string& svg = pictures.at("fig.svg");
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("A `title` of 'it'"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  EXPECT_EQ(drawn(figure(GetParam()), scratch), pictures) << "a PDF file tells no second";
}
INSTANTIATE_TEST_SUITE_P(Kinds, Gnuplot,
                         testing::Values(FigureSpec::Shows::kSegmentations, FigureSpec::Shows::kTime,
                                         FigureSpec::Shows::kFound));

TEST_F(Gnuplot, ThatIsNotThereIsOneClearSentence) {
  const std::string sentence = test::sentence_of<InputError>(
      [&] { (void)drawn(figure(FigureSpec::Shows::kTime), folder.path() / "scratch", "gnuplot-that-is-not-there"); });
  EXPECT_EQ(sentence,
            "gnuplot-that-is-not-there: is not installed, and figures are drawn by it; `apt-get install gnuplot-nox` "
            "brings it");
  EXPECT_EQ(folder.count(), 0U);
}

TEST_F(Gnuplot, ThatFailsIsQuoted) {
  EXPECT_THROW((void)drawn(figure(FigureSpec::Shows::kTime), folder.path() / "scratch", "false"), std::runtime_error);
}

}  // namespace
}  // namespace amiss::experiment
