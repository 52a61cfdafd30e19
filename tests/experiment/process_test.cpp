#include "experiment/process.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>

namespace amiss::experiment {
namespace {

const auto kGoOn = [] { return false; };

Ended shell(const std::string& script, const std::string& input = "") {
  return run_program({"sh", "-c", script}, input, kGoOn);
}

TEST(Process, TellsStatusAndOutput) {
  const Ended ended = shell("read line; echo \"got $line\"; echo wrong >&2; exit 3", "word\n");
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(ended.signal, 0);
  EXPECT_EQ(ended.out, "got word\n");
  EXPECT_EQ(ended.err, "wrong\n");
  EXPECT_FALSE(ended.stopped);
}

TEST(Process, MuchOutputDoesNotHang) {
  const Ended ended = shell("i=0; while [ $i -lt 20000 ]; do echo 0123456789; i=$((i+1)); done; echo end");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.out.size(), 64U * 1024U);
  EXPECT_EQ(ended.out.substr(ended.out.size() - 4), "end\n") << "the last part is kept";
}

TEST(Process, TellsTheSignal) { EXPECT_EQ(shell("kill -9 $$").signal, SIGKILL); }

TEST(Process, ThatIsNotThereHasStatus127) { EXPECT_EQ(run_program({"/nowhere/at/all"}, "", kGoOn).status, 127); }

TEST(Process, StopsWhenAsked) {
  const auto begin = std::chrono::steady_clock::now();
  const Ended ended = run_program(
      {"sleep", "60"}, "", [&] { return std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(100); });
  EXPECT_TRUE(ended.stopped);
  EXPECT_EQ(ended.signal, SIGTERM);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(Process, ThatDoesNotListenIsEnded) {
  const auto begin = std::chrono::steady_clock::now();
  const Ended ended = run_program({"sh", "-c", "trap '' TERM; while :; do sleep 0.1; done"}, "", [&] {
    return std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(500);
  });
  EXPECT_TRUE(ended.stopped);
  EXPECT_EQ(ended.signal, SIGKILL);
}

TEST(Process, KeepsAsMuchAsIsAskedFor) { EXPECT_EQ(run_program({"printf", "0123456789"}, "", kGoOn, 4).out, "6789"); }

}  // namespace
}  // namespace amiss::experiment
