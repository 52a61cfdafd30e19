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
  const std::string page = folder.read("kept/report.html");
  EXPECT_NE(page.find("1 of 1 as expected"), std::string::npos);
  EXPECT_NE(page.find("data:image/jpeg;base64,"), std::string::npos) << "its floor plan";
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

TEST_F(ScenarioCli, WatchedItLeavesARunFolder) {
  const std::string text = kWorld +
                           "time_limit: 3\nevents: [{at: 1, fault: {sensor: camera, kind: 'off'}}]\n"
                           "expect: {end: time_limit, regions: {min: 1}}\n";
  const Ended plain = scenario(text, {"--out", "kept"});
  const Ended ended = scenario(text, {"--view", "--port", "0", "--out", "run"});
  EXPECT_EQ(ended.status, plain.status) << ended.err;
  EXPECT_NE(ended.err.find("watch at http://127.0.0.1:"), std::string::npos) << ended.err;
  EXPECT_EQ(folder.read("run/log.txt"), folder.read("kept/s.log")) << "watching changes nothing";
  EXPECT_EQ(folder.read("run/status"), "finished\n");
  const std::string timeline = folder.read("run/timeline.jsonl"), report = folder.read("run/report.json");
  EXPECT_NE(timeline.find("{\"e\":\"script\",\"t\":1"), std::string::npos);
  EXPECT_NE(report.find("\"as_expected\": false"), std::string::npos) << report;
  EXPECT_NE(folder.read("run/report.html").find("\"as_expected\":false"), std::string::npos);
  EXPECT_EQ(scenario(text, {"--view", "--prove"}).status, 2);
  if (std::system("command -v ffmpeg >/dev/null") != 0) return;
  const Ended film =
      test::run({"video", "run", "--out", "film.gif", "--speed", "10", "--fps", "2", "--width", "160"}, folder.path());
  EXPECT_EQ(film.status, 0) << film.err;
  EXPECT_EQ(folder.read("film.gif").substr(0, 6), "GIF89a");
}

struct RandomScenarioCli : ScenarioCli {
  static std::vector<std::string> words(const std::string& count, const std::string& seed, const std::string& out) {
    const std::string world = AMISS_SOURCE_DIR "/tests/scenarios/worlds/two_rooms.sdf";
    return {"scenario", "--random", count, "--seed", seed, "--world", world, "--out", out};
  }
};

TEST_F(RandomScenarioCli, AreAFunctionOfTheSeed) {
  for (const auto& [seed, out] : {std::pair{"7", "a"}, {"7", "b"}, {"8", "c"}}) {
    std::vector<std::string> arguments = words("3", seed, out);
    arguments.emplace_back("--write-only");
    const Ended ended = test::run(arguments, folder.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
  }
  for (const std::string name : {"random-7-1.yaml", "random-7-2.yaml", "random-7-3.yaml"}) {
    const std::string text = folder.read("a/" + name);
    EXPECT_FALSE(text.empty());
    EXPECT_EQ(folder.read("b/" + name), text);
  }
  EXPECT_NE(folder.read("c/random-8-1.yaml"), folder.read("a/random-7-1.yaml"));
}

TEST_F(RandomScenarioCli, ThoseThatFailAreKeptAndRunAgain) {
  ::setenv("XDG_CACHE_HOME", "/dev/null/none", 1);  // nowhere for the reference: the program fails
  const Ended failed = test::Program(words("1", "7", "kept"), folder.path()).wait();
  EXPECT_EQ(failed.status, 4) << failed.out << failed.err;
  EXPECT_NE(failed.out.find("1 of 1 failed; kept in kept"), std::string::npos) << failed.out;
  const std::string text = folder.read("kept/random-7-1.yaml");
  const Ended again = test::run({"scenario", "kept/random-7-1.yaml"}, folder.path());
  EXPECT_EQ(again.status, 0) << again.out << again.err;
  EXPECT_EQ(folder.read("kept/random-7-1.yaml"), text);
  EXPECT_EQ(test::run(words("1", "7", "kept"), folder.path()).status, 0);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "kept")) << "what holds is not kept";
}

TEST_F(RandomScenarioCli, AKeptFileNamesItsWorldByTheWayFromThere) {
  std::vector<std::string> arguments = words("1", "7", "house/kept");
  arguments[6] = "house/rooms.sdf";
  arguments.emplace_back("--write-only");
  std::filesystem::create_directory(folder.path() / "house");
  folder.write("house/rooms.sdf", R"(<sdf version="1.9"><world name="rooms">
    <frame name="robot_start"><pose>0 0 0 0 0 0</pose></frame>
    <model name="floor"><static>true</static><link name="link"><collision name="c"><pose>0 0 -0.05 0 0 0</pose>
    <geometry><box><size>6 6 0.1</size></box></geometry></collision></link></model></world></sdf>)");
  const Ended ended = test::run(arguments, folder.path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string text = folder.read("house/kept/random-7-1.yaml");
  EXPECT_NE(text.find("world: '../rooms.sdf'"), std::string::npos) << text;
}

TEST_F(RandomScenarioCli, AnInterruptedOneLeavesNothingThatLooksLikeAFailure) {
  test::use_test_cache();
  test::Program program(words("40", "7", "cut"), folder.path());
  const auto waiting = folder.path() / "cut" / "not_judged";
  while (program.runs() && !std::filesystem::exists(waiting / "random-7-40.yaml")) ::usleep(10000);
  ::usleep(500000);
  program.send(SIGINT);
  EXPECT_EQ(program.wait().status, 130);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "cut")) {
    ADD_FAILURE() << entry.path() << " was left";
  }
}

TEST_F(RandomScenarioCli, WhatExcludesEachOtherIsTwo) {
  EXPECT_EQ(test::run({"scenario"}, folder.path()).status, 2);
  EXPECT_EQ(test::run({"scenario", "s.yaml", "--random", "2"}, folder.path()).status, 2);
  EXPECT_EQ(test::run({"scenario", "--prove", "--random", "2"}, folder.path()).status, 2);
  EXPECT_EQ(test::run({"scenario", "s.yaml", "--seed", "2"}, folder.path()).status, 2);
}

}  // namespace
}  // namespace amiss
