#include "experiment/page.hpp"

#include <gtest/gtest.h>

#include "core/temporary_folder.hpp"
#include "experiment/sample_report.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Page, HoldsAllOfAnExperiment) {
  const test::TemporaryFolder folder;
  const fs::path spec_file =
      folder.write("e.yaml", "name: <test>\nworlds: [lab_30]\nmethods: [static]\nobjects: [2]\nruns: 3\n");
  const std::map<std::string, std::string> keys{{"lab_30", "0.1.0\nsearch.look: 0.5\n"}};
  const auto trials = trials_of(load_spec(spec_file), keys, "program");
  const Folder out = Folder::begin(folder.path() / "out", spec_file, trials);
  out.save_basis(keys);
  out.save_result(trials[0], result_text(trials[0], report::to_json(sample_report(), "")), "");
  out.save_result(trials[1], failure_text(trials[1], "status 3: <no> world"), "");

  const std::string html =
      to_html(out, {{"fig", "Time & more", "<?xml?><svg><g id='a'/><use xlink:href='#a'/></svg>"}});
  EXPECT_TRUE(has(html, "<h1>Experiment: &lt;test&gt;</h1>"));
  EXPECT_TRUE(
      has(html, "3 trials planned: 1 found all objects, 0 found not all, 1 failed, 1 are missing. Program program."));
  EXPECT_TRUE(has(html, "status 3: &lt;no&gt; world"));
  EXPECT_TRUE(has(html, "search.look: 0.5"));
  EXPECT_TRUE(has(html, "runs: 3"));
  EXPECT_TRUE(has(html, "<svg><g id='fig-a'/><use xlink:href='#fig-a'/></svg><figcaption>Time &amp; more"));
  EXPECT_EQ(to_html(out, {}), to_html(Folder::open(out.path()), {}));
}

TEST(Page, AsksNobodyForAnything) {
  const test::TemporaryFolder folder;
  const fs::path spec_file =
      folder.write("e.yaml", "name: test\nworlds: [lab_30]\nmethods: [static]\nobjects: [2]\nruns: 1\n");
  const std::map<std::string, std::string> keys{{"lab_30", "key"}};
  const Folder out = Folder::begin(folder.path() / "out", spec_file, trials_of(load_spec(spec_file), keys, "p"));
  out.save_basis(keys);
  const std::string html = to_html(out, {});
  EXPECT_TRUE(has(html, "default-src 'none'"));
  for (const char* word : {"http:", "https:", "<script", "src="}) EXPECT_FALSE(has(html, word)) << word;
}

TEST(Page, FiguresKeepTheirIdsToThemselves) {
  EXPECT_EQ(inlined("<!-- x --><svg><rect id=\"r\" fill=\"url(#p)\"/></svg>", "f"),
            "<svg><rect id=\"f-r\" fill=\"url(#f-p)\"/></svg>");
  EXPECT_EQ(inlined("nothing", "f"), "");
}

}  // namespace
}  // namespace amiss::experiment
