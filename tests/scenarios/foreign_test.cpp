// Whole runs of `amiss tidy` in worlds that others made, and with another robot. Skips where those data are absent.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Ended;
using Words = std::vector<std::string>;

fs::path data() {
  const char* elsewhere = std::getenv("AMISS_TEST_DATA");
  return elsewhere != nullptr ? fs::path(elsewhere) : fs::path(AMISS_SOURCE_DIR).parent_path() / "shared" / "data";
}

struct Foreign : testing::Test {
  test::TemporaryFolder folder;

  void SetUp() override {
    if (!fs::exists(data() / "worlds")) GTEST_SKIP() << data() << " is not there";
  }
  [[nodiscard]] Ended tidy(const Words& more) const {
    Words arguments{"tidy", "--json", "--quiet", "--out", "run"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments, folder.path());
  }
};

struct Arena : Foreign, testing::WithParamInterface<std::string> {};

// Twelve things on the floor, in two rows; those of one row lie in the passage between the two rooms.
TEST_P(Arena, FindsAllTwelve) {
  const fs::path arena = data() / "worlds" / "toyota_wrs2020";
  const Ended ended =
      tidy({"--world", arena / "worlds" / GetParam(), "--reference-world",
            arena / "worlds" / "floor_t0_reference.world", "--model-path", arena / "models", "--model-path",
            data() / "ycb" / "models_light", "--start", "-2.1,1.2,-90", "--time-limit", "600"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_EQ(report["objects_placed"], 12);
  EXPECT_EQ(report["objects_found"], 12);
  EXPECT_EQ(report["collisions"], 0);
  EXPECT_EQ(report["regions"]["false"], 0);
  EXPECT_LE(report["segmentation_actions"], 16);
  EXPECT_LT(report["localization"]["rmse_m"].get<double>(), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Visits, Arena, testing::Values("floor_t1.world", "floor_t2.world"));

// The mapping run is cut short, so that the test is; what it has mapped is searched to the end.
TEST_F(Foreign, SearchesAFurnishedHouse) {
  const fs::path house = data() / "worlds" / "aws_small_house";
  const Ended ended = tidy({"--world", house / "worlds" / "small_house.world", "--model-path", house / "models",
                            "--until", "explored", "--set", "map.max_goals=10", "--time-limit", "1200"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_EQ(report["outcome"], "explored");
  EXPECT_EQ(report["collisions"], 0);
  EXPECT_GE(report["objects_found"], 3);
}

TEST_F(Foreign, RobotOfAnotherMakerFindsAnObject) {
  const fs::path robot = data() / "robots" / "hsr_tri_description" / "hsrb4s.urdf";
  const Ended ended = tidy({"--world", "lab_30", "--objects", "1", "--robot", robot});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_EQ(report["objects_found"], 1);
  EXPECT_EQ(report["collisions"], 0);
}

TEST_F(Foreign, XacroIsRefusedWithASentence) {
  const fs::path xacro = data() / "robots" / "hsr_hsrb_description" / "urdf" / "torso_v0" / "torso.urdf.xacro";
  const Ended ended = tidy({"--world", "lab_30", "--robot", xacro});
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.err.find("expand it with `xacro` first"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace amiss
