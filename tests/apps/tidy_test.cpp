// Whole runs of `amiss tidy` in the small world.
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/program.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Ended;

struct Tidy : testing::Test {
  test::TemporaryFolder folder;

  [[nodiscard]] Ended tidy(const std::string& out, std::vector<std::string> more) const {
    std::vector<std::string> arguments{"tidy", "--world", "lab_30", "--json", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments, folder.path());
  }
};

/// Every key that report.json promises, with those inside.
void expect_complete(const json& report) {
  for (const char* key : {"schema", "version", "world", "seed", "method", "outcome", "objects_placed", "objects_found",
                          "segmentation_actions", "regions", "view_triangles", "coverage", "collisions", "distance_m",
                          "time", "localization", "differencing", "objects", "digest"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  const std::map<std::string, std::vector<std::string>> inside{
      {"regions", {"detected", "false"}},
      {"time", {"simulated_s", "driving_s", "segmenting_s", "wall_s", "real_time_factor"}},
      {"localization", {"rmse_m", "rmse_rad", "max_m"}},
      {"differencing", {"calls", "mean_ms", "max_ms"}}};
  for (const auto& [group, keys] : inside) {
    for (const std::string& key : keys) EXPECT_TRUE(report[group][key].is_number()) << group << "." << key;
  }
  for (const json& object : report["objects"]) {
    for (const char* key : {"name", "position", "found", "found_at_s", "error_m"}) {
      EXPECT_TRUE(object.contains(key)) << key;
    }
  }
}

TEST_F(Tidy, FindsAnObjectAndTellsSo) {
  const Ended ended = tidy("run", {"--objects", "1"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const json report = json::parse(ended.out);  // and nothing else on standard output
  expect_complete(report);
  EXPECT_EQ(report["outcome"], "found");
  EXPECT_EQ(report["objects_found"], 1);
  EXPECT_EQ(report["collisions"], 0);
  EXPECT_EQ(report["objects"][0]["found"], true);
  EXPECT_LT(report["objects"][0]["error_m"].get<double>(), 0.10);
  EXPECT_LT(report["localization"]["rmse_m"].get<double>(), 0.05);
  EXPECT_LT(report["localization"]["rmse_rad"].get<double>(), 0.035);
  EXPECT_GT(report["differencing"]["calls"].get<int>(), 0);
  EXPECT_EQ(ended.err.find('\r'), std::string::npos) << "no progress line in a pipe";

  EXPECT_EQ(folder.read("run/report.json"), ended.out);
  EXPECT_EQ(folder.read("run/status"), "finished\n");
  for (const char* file : {"map.png", "current.ot", "trajectory_truth.txt", "trajectory_estimate.txt", "params.yaml",
                           "log.txt", "knowledge.sqlite", "plans/domain.pddl"}) {
    EXPECT_GT(fs::file_size(folder.path() / "run" / file), 0U) << file;
  }
  const std::string name = report["objects"][0]["name"];
  EXPECT_TRUE(fs::exists(folder.path() / "run" / "objects" / (name + ".png")));
  EXPECT_EQ(tidy("run", {"--objects", "1"}).status, 2) << "a finished run is not overwritten";
}

TEST_F(Tidy, TheStaticMethodSegmentsAtViewTriangles) {
  const std::vector<std::string> same_things{"--objects", "1", "--scatter-seed", "9"};
  std::vector<std::string> arguments = same_things;
  arguments.insert(arguments.end(), {"--method", "static", "--time-limit", "600"});
  const Ended ended = tidy("static", arguments);
  ASSERT_LE(ended.status, 1) << ended.err;
  const json report = json::parse(ended.out);
  expect_complete(report);
  EXPECT_EQ(report["method"], "static");
  EXPECT_EQ(report["regions"]["detected"], 0) << "it does not compare";
  EXPECT_EQ(report["differencing"]["calls"], 0);
  EXPECT_EQ(report["collisions"], 0);
  const int actions = report["segmentation_actions"];
  EXPECT_GT(actions, 0);
  EXPECT_NEAR(report["segmentation"]["cost_s"].get<double>(), 6.0 * actions, 1e-6);
  const json& times = report["time"]["search_s"];
  EXPECT_NEAR(times["simulation"].get<double>(), report["time"]["simulated_s"].get<double>(), 1e-3);
  EXPECT_NEAR(times["real_robot"].get<double>() - times["fast"].get<double>(), 8.96 * actions, 1e-3);
  EXPECT_EQ(report["outcome"], "found");

  arguments = same_things;
  arguments.insert(arguments.end(), {"--until", "explored", "--time-limit", "3", "--seed", "8"});
  const json dynamic = json::parse(tidy("dynamic", arguments).out);
  for (const std::size_t axis : {0U, 1U}) {  // a banana still rocks by less than a millimetre
    EXPECT_NEAR(dynamic["objects"][0]["position"][axis].get<double>(),
                report["objects"][0]["position"][axis].get<double>(), 0.005);
  }
}

TEST_F(Tidy, OneThreadOrTwoGiveTheSameDigest) {
  const std::vector<std::string> arguments{"--objects", "3",        "--seed",       "7",
                                           "--until",   "explored", "--time-limit", "30"};
  std::vector<std::string> one = arguments, two = arguments;
  one.insert(one.end(), {"--threads", "1"});
  two.insert(two.end(), {"--threads", "2"});
  const Ended first = tidy("one", one), second = tidy("two", two);
  ASSERT_LE(first.status, 1) << first.err;
  ASSERT_EQ(second.status, first.status) << second.err;
  const json a = json::parse(first.out), b = json::parse(second.out);
  EXPECT_EQ(a["digest"], b["digest"]);
  EXPECT_GT(a["time"]["simulated_s"].get<double>(), 10.0);
  EXPECT_EQ(folder.read("one/trajectory_estimate.txt"), folder.read("two/trajectory_estimate.txt"));
  EXPECT_EQ(folder.read("one/current.ot"), folder.read("two/current.ot"));
}

TEST_F(Tidy, AnotherSeedIsAnotherRun) {
  const std::vector<std::string> shared{"--objects", "2", "--until", "explored", "--time-limit", "5", "--seed"};
  std::vector<std::string> one = shared, two = shared;
  one.emplace_back("1");
  two.emplace_back("2");
  EXPECT_NE(json::parse(tidy("one", one).out)["digest"], json::parse(tidy("two", two).out)["digest"]);
}

/// Waits until `ready` says so or the program has ended.
template <class Ready>
bool wait_for(const test::Program& program, const Ready& ready) {
  for (int i = 0; i < 6000 && program.runs(); ++i) {
    if (ready()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

TEST_F(Tidy, InterruptedWhileItSearches) {
  test::use_test_cache();
  test::Program program({"tidy", "--world", "lab_30", "--until", "explored", "--out", "run", "--json"}, folder.path());
  const fs::path plans = folder.path() / "run" / "plans";
  ASSERT_TRUE(
      wait_for(program, [&] { return fs::exists(plans) && std::distance(fs::directory_iterator(plans), {}) > 1; }));
  program.send(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.status, 130) << ended.err;
  EXPECT_EQ(folder.read("run/status"), "interrupted\n");
  EXPECT_FALSE(fs::exists(folder.path() / "run" / "report.json"));
  EXPECT_EQ(json::parse(folder.read("run/report.partial.json"))["outcome"], "interrupted");
}

TEST_F(Tidy, InterruptedWhileItMaps) {
  fs::create_directory(folder.path() / "cache");
  ::setenv("XDG_CACHE_HOME", (folder.path() / "cache").c_str(), 1);
  test::Program program({"tidy", "--world", "lab_30", "--out", "run"}, folder.path());
  const auto seen_mapping = [&] { return fs::exists(folder.path() / "run" / "params.yaml"); };
  ASSERT_TRUE(wait_for(program, seen_mapping));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  program.send(SIGTERM);
  EXPECT_EQ(program.wait().status, 130);
  EXPECT_EQ(folder.read("run/status"), "interrupted\n");
  EXPECT_FALSE(fs::exists(folder.path() / "cache" / "amiss" / "references")) << "no half of a reference";
}

TEST_F(Tidy, KilledRunsDoNotLookFinishedAndMayBeStartedAgain) {
  test::use_test_cache();
  {
    test::Program program({"tidy", "--world", "lab_30", "--until", "explored", "--out", "run"}, folder.path());
    ASSERT_TRUE(wait_for(program, [&] { return fs::exists(folder.path() / "run" / "knowledge.sqlite"); }));
    program.send(SIGKILL);
  }
  EXPECT_EQ(folder.read("run/status"), "running\n");
  EXPECT_FALSE(fs::exists(folder.path() / "run" / "report.json"));
  EXPECT_EQ(tidy("run", {"--until", "explored", "--time-limit", "3"}).status, 1);
  EXPECT_EQ(folder.read("run/status"), "finished\n");
}

}  // namespace
}  // namespace amiss
