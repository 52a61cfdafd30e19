// `amiss scenario` as its users see it: wrong files, failed expectations and failed programs are told apart.
#include <gtest/gtest.h>

#include "apps/program.hpp"

namespace amiss {
namespace {

using test::Ended;

const std::string kWorld = "world: " AMISS_SOURCE_DIR "/tests/scenarios/worlds/two_rooms.sdf\n";

struct ScenarioCli : testing::Test {
  test::TemporaryFolder folder;
  Ended scenario(const std::string& text, const std::vector<std::string>& more = {}) {
    folder.write("s.yaml", text);
    std::vector<std::string> arguments{"scenario", "s.yaml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments, folder.path());
  }
};

TEST_F(ScenarioCli, AsExpected) {
  const Ended ended = scenario(kWorld + "time_limit: 1\nexpect: {end: time_limit, exit_status: 1, collisions: 0}\n",
                               {"--junit", "out.xml", "--out", "kept"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_NE(folder.read("out.xml").find("failures=\"0\" errors=\"0\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "kept" / "s.png"));
}

TEST_F(ScenarioCli, AFailedExpectationIsOne) {
  const Ended ended = scenario(kWorld + "time_limit: 1\nexpect: {end: explored}\n", {"--junit", "out.xml"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.out.find("end: explored: it ended with time_limit"), std::string::npos) << ended.out;
  EXPECT_NE(folder.read("out.xml").find("<failure message"), std::string::npos);
}

TEST_F(ScenarioCli, AWrongScenarioIsTwoOrThree) {
  const Ended unread = scenario(kWorld + "expekt: {}\n");
  EXPECT_EQ(unread.status, 3);
  EXPECT_NE(unread.err.find("s.yaml:2:1: unknown key 'expekt'; did you mean 'expect'?"), std::string::npos)
      << unread.err;
  const Ended parameter = scenario(kWorld + "params: {change.min_voxel: 3}\nexpect: {}\n", {"--junit", "out.xml"});
  EXPECT_EQ(parameter.status, 2) << parameter.out;
  EXPECT_NE(parameter.out.find("s.yaml:2:28: there is no parameter 'change.min_voxel'"), std::string::npos)
      << parameter.out;
  EXPECT_NE(folder.read("out.xml").find("<error message"), std::string::npos);
  EXPECT_EQ(scenario(kWorld + "events: [{remove: {name: sofa}}]\nexpect: {}\n").status, 2);
}

TEST_F(ScenarioCli, WhatIsBrokenMustFail) {
  const Ended ended = scenario(
      kWorld + "time_limit: 1\nexpect: {end: time_limit}\nbreaks: [{params: {change.min_voxels: 3}}]\n", {"--prove"});
  EXPECT_EQ(ended.status, 1) << ended.out;
  EXPECT_NE(ended.out.find("broken on purpose, something should have failed; what failed: nothing"), std::string::npos)
      << ended.out;
}

}  // namespace
}  // namespace amiss
