// An experiment of twelve trials whose amiss is a stand-in (work.cpp), and what came of it.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

#include "core/temporary_folder.hpp"
#include "experiment/folder.hpp"
#include "experiment/runner.hpp"

namespace amiss::experiment {

/// A variable of the environment with another value, for a while.
class Variable {
 public:
  Variable(std::string name, const std::string& value) : name_(std::move(name)) {
    if (const char* before = ::getenv(name_.c_str())) before_ = before;
    ::setenv(name_.c_str(), value.c_str(), 1);
  }
  ~Variable() {
    if (before_) {
      ::setenv(name_.c_str(), before_->c_str(), 1);
    } else {
      ::unsetenv(name_.c_str());
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  std::string name_;
  std::optional<std::string> before_;
};

struct StandInExperiment : testing::Test {
  test::TemporaryFolder folder;
  std::string program = EXPERIMENT_STAND_IN;
  std::vector<std::string> told;
  std::mutex telling;

  [[nodiscard]] Folder begin(const std::string& name, double seconds = 0.0) const {
    const auto spec_file =
        folder.write("e.yaml",
                     "name: test\nworlds: [lab_30]\nmethods: [dynamic, static]\nobjects: [2]\nruns: 6\n"
                     "params: {stand_in.seconds: " +
                         std::to_string(seconds) + "}\n");
    return Folder::begin(folder.path() / name, spec_file,
                         trials_of(load_spec(spec_file), {{"lab_30", "key"}}, "program"));
  }
  RunHooks hooks() {
    RunHooks hooks;
    hooks.tell = [this](const std::string& sentence) {
      const std::lock_guard lock(telling);
      told.push_back(sentence);
    };
    return hooks;
  }
  [[nodiscard]] std::string all_told() {
    const std::lock_guard lock(telling);
    std::string all;
    for (const std::string& sentence : told) all += sentence + "\n";
    return all;
  }
  /// Of a run here, one trial after the other.
  [[nodiscard]] std::map<std::string, std::string> expected_files() {
    const Folder local = begin("local");
    EXPECT_TRUE(run_trials(local, local.missing(), 1, program, hooks()));
    for (const TrialResult& result : local.results()) EXPECT_FALSE(result.failed) << result.why;
    return files_of(local);
  }
  /// All that an experiment leaves, but for the stand-in's notes.
  [[nodiscard]] static std::map<std::string, std::string> files_of(const Folder& from) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(from.path())) {
      if (!entry.is_regular_file() || entry.path().filename() == "ran.log") continue;
      std::ostringstream bytes;
      bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
      files[std::filesystem::relative(entry.path(), from.path())] = bytes.str();
    }
    return files;
  }
  /// How often each trial was begun.
  [[nodiscard]] static std::map<std::string, int> ran(const Folder& from) {
    std::map<std::string, int> times;
    std::ifstream lines(from.path() / "ran.log");
    for (std::string id; std::getline(lines, id);) ++times[id.substr(0, id.find('.'))];
    return times;
  }
};

}  // namespace amiss::experiment
