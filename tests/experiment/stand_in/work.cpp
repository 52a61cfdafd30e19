// Stands for amiss on a cluster: `experiment work DIR ID...` as the program has it, and a `tidy` that takes a moment
// (--set=stand_in.seconds=S), adds a line to DIR/ran.log and leaves a report that depends on the seed.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iostream>
#include <thread>

#include "core/files.hpp"
#include "experiment/runner.hpp"
#include "experiment/sample_report.hpp"

namespace {

using namespace amiss;
namespace fs = std::filesystem;

volatile std::sig_atomic_t caught = 0;

int work(int argc, char** argv) {
  const auto folder = experiment::Folder::open(argv[3]);
  experiment::RunHooks hooks;
  hooks.stop = [] { return caught != 0; };
  for (int i = 4; i < argc; ++i) {
    if (!run_trial(folder, folder.trial(argv[i]), "/proc/self/exe", hooks)) return 130;
  }
  return 0;
}

int tidy(int argc, char** argv) {
  report::TidyReport report = experiment::sample_report();
  fs::path out;
  double seconds = 0.0;
  for (int i = 2; i < argc; ++i) {
    const std::string word(argv[i]);
    const auto value = [&](const std::string& key) { return word.starts_with(key) ? word.substr(key.size()) : ""; };
    if (!value("--out=").empty()) out = value("--out=");
    if (!value("--seed=").empty()) report.seed = std::stoull(value("--seed="));
    if (!value("--set=stand_in.seconds=").empty()) seconds = std::stod(value("--set=stand_in.seconds="));
  }
  const fs::path mine = out.parent_path();  // DIR/work/ID...
  std::ofstream(mine.parent_path().parent_path() / "ran.log", std::ios::app) << mine.stem().stem().string() + "\n";
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  report.distance_m = static_cast<double>(report.seed) * 1.5;
  fs::create_directories(out);
  save_atomically(out / "report.json", report::to_json(report, ""));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGTERM, [](int) { caught = 1; });
  const std::string command = argc > 1 ? argv[1] : "";
  try {
    if (command == "experiment" && argc > 3) return work(argc, argv);
    if (command == "tidy") return tidy(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "stand-in: " << e.what() << "\n";
  }
  return 3;
}
