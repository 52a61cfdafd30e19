// amiss doctor: what is there of what amiss needs and can use. Status 1 when something that it needs is missing.
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>
#include <thread>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "library_versions.hpp"
#include "resources.hpp"
#include "robot/model.hpp"
#include "sim/renderer.hpp"
#include "world/catalogue.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr double kGigabyte = 1e9;
constexpr double kLeastFree = 0.2 * kGigabyte;    // a run folder and a reference take less
constexpr double kLeastMemory = 1.0 * kGigabyte;  // a run in the large flat takes less

enum class State { kGood, kAbsent, kBad };  // kAbsent: amiss does without

struct Finding {
  State state;
  std::string what, how;
};

/// What `look` says, or why it could not.
template <class Look>
Finding examined(const std::string& what, const Look& look) {
  try {
    return look();
  } catch (const std::exception& e) {
    return {State::kBad, what, e.what()};
  }
}

Finding machine() {
  utsname system{};
  ::uname(&system);
  const double memory = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  return {memory < kLeastMemory ? State::kBad : State::kGood, "machine",
          fmt::format("{} {}, {} cores, {:.1f} GB of memory", system.sysname, system.machine,
                      std::thread::hardware_concurrency(), memory / kGigabyte)};
}

Finding data() {
  const Resources resources = find_resources();
  const std::size_t worlds = world_names(resources).size();
  const std::size_t objects = world::load_catalogue({resources.objects}).entries.size();
  const robot::Model model = robot::load_model(resources.robot);
  return {worlds > 0 && objects > 0 ? State::kGood : State::kBad, "data",
          fmt::format("{} worlds, {} objects, robot of {} links; {}", worlds, objects, model.links.size(),
                      resources.worlds.parent_path().string())};
}

/// Room on the disk of `folder`, and whether it can be written to.
Finding place(const std::string& what, const fs::path& folder) {
  fs::create_directories(folder);
  const fs::path probe = folder / fmt::format(".amiss-doctor-{}", ::getpid());
  save_atomically(probe, "written");
  fs::remove(probe);
  const double free = static_cast<double>(fs::space(folder).available);
  return {free < kLeastFree ? State::kBad : State::kGood, what,
          fmt::format("{:.1f} GB free, writable; {}", free / kGigabyte, fs::absolute(folder).string())};
}

Finding renderer() { return {State::kGood, "OSMesa", sim::opengl_version()}; }

/// What a shell command writes, if it ends well.
std::optional<std::string> output_of(const std::string& command) {
  std::string text;
  FILE* pipe = ::popen((command + " 2>/dev/null </dev/null").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::array<char, 200> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) text += buffer.data();
  return ::pclose(pipe) == 0 ? std::optional(text.substr(0, text.find_last_not_of('\n') + 1)) : std::nullopt;
}

Finding slurm() {
  const auto sbatch = output_of("command -v sbatch");
  if (!sbatch) return {State::kAbsent, "Slurm", "not installed: no cluster to spread experiments over"};
  const auto nodes = output_of("sinfo --noheader --format='%D nodes in partition %P, %a' --noconvert");
  if (!nodes) return {State::kAbsent, "Slurm", *sbatch + ", but no controller answers"};
  return {State::kGood, "Slurm", *sbatch + ", " + *nodes};
}

Finding ffmpeg() {
  const auto version = output_of("ffmpeg -version");
  if (!version) return {State::kAbsent, "ffmpeg", "not installed: amiss video cannot make films"};
  return {State::kGood, "ffmpeg", version->substr(0, version->find(" Copyright"))};
}

Finding gnuplot() {
  const auto version = output_of("gnuplot --version");
  if (!version) return {State::kAbsent, "gnuplot", "not installed: no figures of experiments and evaluations"};
  return {State::kGood, "gnuplot", *version};
}

Finding parallel() {
  const auto version = output_of("parallel --version");
  if (!version || !version->starts_with("GNU parallel")) {  // moreutils has another program of that name
    return {State::kAbsent, "GNU parallel", "not installed: experiments are run here or by Slurm"};
  }
  return {State::kGood, "GNU parallel", version->substr(0, version->find('\n'))};
}

int run() {
  const std::vector<Finding> findings{
      {State::kGood, "amiss", AMISS_VERSION ", " + fs::read_symlink("/proc/self/exe").string()},
      machine(),
      examined("data", data),
      examined("this folder", [] { return place("this folder", fs::current_path()); }),
      examined("cache", [] { return place("cache", cache_folder()); }),
      examined("OSMesa", renderer),
      {State::kGood, "libraries", library_versions()},
      ffmpeg(),
      gnuplot(),
      parallel(),
      slurm()};
  bool good = true;
  for (const Finding& f : findings) {
    const char* state = f.state == State::kGood ? "ok" : f.state == State::kAbsent ? "-" : "BAD";
    std::cout << fmt::format("{:<5}{:<13}{}\n", state, f.what, f.how);
    good = good && f.state != State::kBad;
  }
  std::cout << (good ? "amiss can run here\n" : "amiss cannot run here as it is\n");
  return good ? kGoalMet : kGoalNotMet;
}

}  // namespace

void add_doctor_command(CLI::App& app, int& exit_status) {
  app.add_subcommand("doctor", "what is installed, and whether amiss can run here")->callback([&exit_status] {
    exit_status = run();
  });
}

}  // namespace amiss::app
