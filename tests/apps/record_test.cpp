// `amiss tidy --record` and `amiss replay`: recording changes nothing, a replay finds what the run found.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "apps/program.hpp"
#include "core/files.hpp"
#include "knowledge/knowledge_base.hpp"

namespace amiss {
namespace {

using test::Ended;

const std::vector<std::string> kSearch{"tidy",      "--world", AMISS_SOURCE_DIR "/tests/scenarios/worlds/two_rooms.sdf",
                                       "--objects", "2",       "--seed",
                                       "3",         "--json"};

struct Record : testing::Test {
  test::TemporaryFolder folder;

  [[nodiscard]] Ended amiss(std::vector<std::string> arguments, const std::vector<std::string>& more = {}) const {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments, folder.path());
  }
  [[nodiscard]] knowledge::Knowledge known(const std::string& run) const {
    return knowledge::KnowledgeBase(folder.path() / run / "knowledge.sqlite", {}).now();
  }
};

TEST_F(Record, AReplayFindsWhatTheRunFoundAndRecordingChangesNothing) {
  const Ended plain = amiss(kSearch, {"--out", "plain"});
  const Ended recorded = amiss(kSearch, {"--out", "run", "--record", "both", "--threads", "1"});
  ASSERT_EQ(recorded.status, plain.status) << recorded.err;
  EXPECT_EQ(nlohmann::json::parse(recorded.out).at("digest"), nlohmann::json::parse(plain.out).at("digest"));

  const Ended replayed = amiss({"replay", "run/recording.mcap", "--out", "again", "--json"});
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  EXPECT_TRUE(nlohmann::json::parse(replayed.out).at("complete"));
  const knowledge::Knowledge then = known("run"), now = known("again");
  EXPECT_FALSE(then.regions.empty());
  EXPECT_EQ(then.regions, now.regions);
  EXPECT_FALSE(then.objects.empty());
  EXPECT_EQ(then.objects, now.objects);
  EXPECT_EQ(sha256(folder.read("run/current.ot")), sha256(folder.read("again/current.ot")));

  const Ended from_rawlog = amiss({"replay", "run/recording.rawlog", "--out", "third", "--json"});
  ASSERT_EQ(from_rawlog.status, 0) << from_rawlog.err;
  EXPECT_EQ(from_rawlog.out, replayed.out) << "regions and objects, digit for digit";
  EXPECT_EQ(sha256(folder.read("run/current.ot")), sha256(folder.read("third/current.ot")));

  const std::string whole = folder.read("run/recording.rawlog");
  folder.write("cut.rawlog", std::string_view(whole).substr(0, whole.size() / 2));
  const Ended cut = amiss({"replay", "cut.rawlog", "--json"});
  ASSERT_EQ(cut.status, 0) << cut.err;
  const auto report = nlohmann::json::parse(cut.out);
  EXPECT_FALSE(report.at("complete"));
  EXPECT_GT(report.at("frames"), 3);
}

/// Simulated seconds up to which the run came, as its timeline tells.
double last_moment(const std::string& timeline) {
  double last_s = 0.0;
  std::istringstream lines(timeline);
  for (std::string line; std::getline(lines, line) && !lines.eof();) {
    last_s = std::max(last_s, nlohmann::json::parse(line).value("t", 0.0));
  }
  return last_s;
}

TEST_F(Record, ARunThatWasKilledIsReplayedUpToItsLastSecond) {
  test::use_test_cache();
  std::vector<std::string> words = kSearch;
  words.insert(words.end(), {"--out", "run", "--record", "both", "--until", "explored"});
  test::Program program(words, folder.path());
  const auto file = folder.path() / "run" / "recording.mcap";
  const auto recorded = [&] { return std::filesystem::exists(file) ? std::filesystem::file_size(file) : 0; };
  while (program.runs() && recorded() < 6'000'000) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_TRUE(program.runs());
  program.send(SIGKILL);
  program.wait();
  const double reached_s = last_moment(folder.read("run/timeline.jsonl"));
  ASSERT_GT(reached_s, 2.0);
  for (const char* recording : {"run/recording.mcap", "run/recording.rawlog"}) {
    const Ended replayed = amiss({"replay", recording, "--json"});
    ASSERT_EQ(replayed.status, 0) << replayed.err;
    const auto report = nlohmann::json::parse(replayed.out);
    EXPECT_FALSE(report.at("complete"));
    EXPECT_GT(report.at("frames"), 3);
    EXPECT_GE(report.at("simulated_s").get<double>(), reached_s - 1.0) << recording;
  }
}

TEST_F(Record, WhatIsNoRecordingIsRefused) {
  folder.write("x.mcap", "nothing");
  const Ended ended = amiss({"replay", "x.mcap"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.err.find("x.mcap: is no MCAP file"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace amiss
