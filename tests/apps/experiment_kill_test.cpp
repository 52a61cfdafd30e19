// Experiments that are killed and taken up again, by the program itself. A short one here; the long one is
//   AMISS_KILLS=20 AMISS_KILLED_SPEC=share/experiments/small.yaml build/release/tests/apps/experiment_kill_test
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <thread>

#include "apps/program.hpp"
#include "core/files.hpp"
#include "core/random.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using test::Ended;

struct Experiment : testing::Test {
  test::TemporaryFolder folder;
  fs::path spec = folder.write("spec.yaml",
                               "name: short\nworlds: [lab_30]\nmethods: [dynamic, static]\nobjects: [1]\nruns: 1\n"
                               "scatter_seed: 100\n");
  int kills = 3;

  Experiment() {
    if (const char* other = std::getenv("AMISS_KILLED_SPEC")) spec = fs::absolute(other);
    if (const char* many = std::getenv("AMISS_KILLS")) kills = std::atoi(many);
  }
  [[nodiscard]] Ended amiss(const std::vector<std::string>& arguments) const {
    std::vector<std::string> words{"experiment"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return test::run(words, folder.path());
  }
  [[nodiscard]] std::vector<std::string> run_of(const std::string& out, const std::string& jobs) const {
    return {"run", spec, "--out", out, "-j", jobs};
  }
  [[nodiscard]] std::map<std::string, std::string> results_of(const std::string& out) const {
    std::map<std::string, std::string> results;
    if (!fs::exists(folder.path() / out / "trials")) return results;
    for (const auto& entry : fs::directory_iterator(folder.path() / out / "trials")) {
      if (entry.path().extension() == ".json") results[entry.path().filename()] = load_bytes(entry.path());
    }
    return results;
  }
  /// Whole by its own judgement, and every merged file as that of the other one.
  void expect_whole_and_as(const std::string& out, const std::string& other) const {
    const Ended verified = amiss({"verify", out});
    EXPECT_EQ(verified.status, 0) << verified.out;
    EXPECT_EQ(amiss({"merge", out}).status, 0);
    for (const char* name : {"results.tsv", "summary.tsv", "statistics.tsv"}) {
      EXPECT_EQ(load_bytes(folder.path() / out / name), load_bytes(folder.path() / other / name)) << name;
    }
    EXPECT_EQ(results_of(out), results_of(other));
  }
  /// Starts a run and kills it after a while; false when it had ended by then.
  [[nodiscard]] bool kill_after(double seconds_s) const {
    test::use_test_cache();
    std::vector<std::string> words{"experiment"};
    for (const std::string& word : run_of("killed", "2")) words.push_back(word);
    test::Program program(words, folder.path());
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds_s);
    while (program.runs() && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (!program.runs()) return false;
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().status, -1000 - SIGKILL);
    return true;
  }
};

TEST_F(Experiment, KilledAtAnyTimeNothingIsLostAndNothingDoubled) {
  ASSERT_EQ(amiss({"plan", spec}).status, 0);
  const Ended first = amiss(run_of("whole", "1"));
  ASSERT_EQ(first.status, 0) << first.err;
  ASSERT_EQ(amiss({"merge", "whole"}).status, 0);
  const auto whole = results_of("whole");
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(amiss(run_of("again", "2")).status, 0);
  const double takes_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  expect_whole_and_as("again", "whole");

  RandomStream random(1, "kill");
  for (int killed = 0; killed < kills;) {
    if (kill_after(random.uniform(0.0, takes_s))) {
      ++killed;
      for (const auto& [name, bytes] : results_of("killed")) EXPECT_EQ(bytes, whole.at(name));
    } else {
      expect_whole_and_as("killed", "whole");
      fs::remove_all(folder.path() / "killed");
    }
  }
  ASSERT_EQ(amiss(run_of("killed", "2")).status, 0);
  expect_whole_and_as("killed", "whole");
}

TEST_F(Experiment, TellsWhatIsWrongWithAFolder) {
  EXPECT_EQ(amiss({"verify", "."}).status, 3);
  EXPECT_EQ(amiss({"merge", "nowhere"}).status, 3);
  EXPECT_EQ(amiss({"plot", "nowhere"}).status, 3);
  const auto one = folder.write("one.yaml",
                                "name: one\nworlds: [lab_30]\nmethods: [dynamic]\nobjects: [1]\nruns: 1\n"
                                "scatter_seed: 100\nfigures:\n"
                                "  - {name: fig, title: Time, world: lab_30, shows: time, times: [fast]}\n");
  EXPECT_EQ(amiss({"run", one, "--out", "out", "-j", "1"}).status, 0);
  const Ended plotted = amiss({"plot", "out"});
  EXPECT_TRUE(fs::exists(folder.path() / "out" / "figures" / "fig.gp"));
  if (plotted.status == 0) {
    EXPECT_NE(load_bytes(folder.path() / "out" / "report.html").find("<svg"), std::string::npos);
  } else {
    EXPECT_EQ(plotted.status, 3);
    EXPECT_NE(plotted.err.find("gnuplot: is not installed"), std::string::npos) << plotted.err;
  }
  const fs::path result = *begin(fs::directory_iterator(folder.path() / "out" / "trials"));
  std::string bytes = load_bytes(result);
  bytes.replace(bytes.find("\"found\": true"), 13, "\"found\": null");
  save_atomically(result, bytes);
  const Ended changed = amiss({"verify", "out"});
  EXPECT_EQ(changed.status, 1);
  EXPECT_NE(changed.out.find("was changed since it was written"), std::string::npos) << changed.out;
  fs::remove(result);
  const Ended missing = amiss({"verify", "out"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.out.find("has no result"), std::string::npos) << missing.out;
  EXPECT_EQ(amiss({"merge", "out"}).status, 1);
}

}  // namespace
}  // namespace amiss
