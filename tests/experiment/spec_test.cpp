#include "experiment/spec.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::experiment {
namespace {

const std::string kWhole =
    "name: test\nworlds: [lab_30]\nmethods: [dynamic, static]\nobjects: [1, 3]\nruns: 4\nfirst_seed: 11\n"
    "scatter_seed: 100\ntime_limit: 600\nparams: {search.look: 0.5}\n"
    "figures:\n  - {name: f1, title: Time, world: lab_30, shows: time, times: [fast]}\n";

struct SpecFile : testing::Test {
  test::TemporaryFolder folder;
  [[nodiscard]] Spec load(const std::string& text) const { return load_spec(folder.write("e.yaml", text)); }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    const std::string sentence = test::sentence_of<ArgumentError>([&] { (void)load(text); });
    const auto at = sentence.find("e.yaml:");
    return at == std::string::npos ? sentence : sentence.substr(at);
  }
};

TEST_F(SpecFile, IsRead) {
  const Spec spec = load(kWhole);
  EXPECT_EQ(spec.methods, (std::vector<std::string>{"dynamic", "static"}));
  EXPECT_EQ(spec.objects, (std::vector<int>{1, 3}));
  EXPECT_EQ(spec.runs, 4);
  EXPECT_EQ(spec.first_seed, 11U);
  EXPECT_EQ(spec.time_limit_s, 600.0);
  ASSERT_EQ(spec.params.size(), 1U);
  EXPECT_EQ(spec.params[0].first + "=" + spec.params[0].second, "search.look=0.5");
  ASSERT_EQ(spec.figures.size(), 1U);
  EXPECT_EQ(spec.figures[0].shows, FigureSpec::Shows::kTime);
  EXPECT_EQ(spec.figures[0].times, std::vector<std::string>{"fast"});
}

TEST_F(SpecFile, WrongOnesAreRefusedByLine) {
  EXPECT_EQ(refusal(kWhole + "run: 3\n").substr(0, 43), "e.yaml:12: there is no key 'run'; allowed: ");
  EXPECT_EQ(refusal("name: test\nworlds: [lab_30]\nmethods: [dynamo]\nobjects: [1]\nruns: 4\n"),
            "e.yaml:3: 'dynamo' is not allowed; allowed: dynamic, static");
  EXPECT_EQ(refusal("name: test\nworlds: [lab_30]\nmethods: [static]\nobjects: [0]\nruns: 4\n"),
            "e.yaml:4: 0 is not allowed; allowed: 1 .. 100");
  EXPECT_EQ(refusal("name: test\nworlds: [a, a]\nmethods: [static]\nobjects: [1]\nruns: 4\n"),
            "e.yaml:2: stands twice; once is allowed");
  EXPECT_EQ(refusal("name: test\nworlds: [a]\nmethods: [static]\nobjects: [1]\n"), "e.yaml:1: runs is missing");
  EXPECT_EQ(refusal("name: test\nworlds: [a]\nmethods: [static]\nobjects: [1]\nruns: many\n"),
            "e.yaml:5: a number is needed; allowed: 1 .. 100000");
  EXPECT_EQ(refusal("name: [\n").substr(0, 9), "e.yaml:2:");
  EXPECT_THROW((void)load_spec(folder.path() / "none.yaml"), InputError);
}

TEST_F(SpecFile, FiguresSpeakOfWhatIsThere) {
  const std::string head = kWhole.substr(0, kWhole.find("figures"));
  EXPECT_EQ(refusal(head + "figures:\n  - {name: f, title: t, world: flat_90, shows: time, times: [fast]}\n"),
            "e.yaml:11: 'flat_90' is not allowed; allowed: lab_30");
  EXPECT_EQ(refusal(head + "figures:\n  - {name: ../f, title: t, world: lab_30, shows: segmentations}\n"),
            "e.yaml:11: letters, digits, _ and - are allowed in the name of a figure");
  EXPECT_EQ(refusal(head + "figures:\n  - {name: f, title: t, world: lab_30, shows: found}\n"),
            "e.yaml:11: times is missing: with which segmentation times the figure is drawn");
}

TEST_F(SpecFile, ThoseThatComeWithAmissLoad) {
  const std::filesystem::path all = AMISS_SOURCE_DIR "/share/experiments";
  const Spec chapter4 = load_spec(all / "chapter4.yaml");
  EXPECT_EQ(chapter4.worlds.size() * chapter4.methods.size() * chapter4.objects.size() *
                static_cast<std::size_t>(chapter4.runs),
            160U);
  EXPECT_EQ(load_spec(all / "chapter4_100.yaml").runs, 100);
  EXPECT_EQ(load_spec(all / "small.yaml").worlds, std::vector<std::string>{"lab_30"});
}

}  // namespace
}  // namespace amiss::experiment
