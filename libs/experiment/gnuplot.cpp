#include "experiment/gnuplot.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "core/files.hpp"
#include "core/result.hpp"
#include "experiment/process.hpp"

namespace amiss::experiment {

namespace fs = std::filesystem;

namespace {

constexpr int kNotFound = 127;  // of env

struct Scratch {
  explicit Scratch(fs::path path) : folder(std::move(path)) { fs::create_directories(folder); }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path folder;
};

/// The time of drawing in a PDF file, in place, since the file counts its bytes.
void forget_date(std::string& picture) {
  constexpr std::string_view kKey = "/CreationDate (D:", kNoDate = "20000101000000";
  const std::size_t at = picture.find(kKey);
  if (at != std::string::npos) picture.replace(at + kKey.size(), kNoDate.size(), kNoDate);
}

}  // namespace

std::map<std::string, std::string> drawn(const Figure& figure, const fs::path& scratch_folder,
                                         const std::string& program) {
  const Scratch scratch(scratch_folder);
  for (const auto& [name, bytes] : figure.files) save_atomically(scratch.folder / name, bytes);
  std::map<std::string, std::string> pictures;
  for (const char* format : kFigureFormats) {
    // A point in numbers is a point in every country.
    const Ended ended = run_program({"env", "-C", scratch.folder.string(), "TZ=UTC", "LC_ALL=C.UTF-8", program, "-e",
                                     fmt::format("format='{}'", format), figure.name + ".gp"},
                                    "", [] { return false; });
    if (ended.status == kNotFound) {
      throw InputError(program +
                       ": is not installed, and figures are drawn by it; `apt-get install gnuplot-nox` "
                       "brings it");
    }
    const std::string name = figure.name + "." + format;
    if (ended.status != 0 || ended.signal != 0 || !fs::exists(scratch.folder / name)) {
      throw std::runtime_error(fmt::format("{}: gnuplot cannot draw it: {}", name, ended.err));
    }
    pictures[name] = load_bytes(scratch.folder / name);
    forget_date(pictures[name]);
  }
  return pictures;
}

}  // namespace amiss::experiment
