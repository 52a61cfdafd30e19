// A program run as a child: arguments -> how it ended and what it said. The child dies with its parent.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace amiss::experiment {

struct Ended {
  int status = 0;        // exit status
  int signal = 0;        // that ended it, else 0
  bool stopped = false;  // because `stop` asked for it
  std::string out, err;  // the last bytes of each
};

/// `input`: what the child reads. `stop` is asked many times a second; the child then gets SIGTERM, and SIGKILL when it
/// is still there seconds later. `kept`: bytes of output. std::runtime_error when no child can be made.
[[nodiscard]] Ended run_program(const std::vector<std::string>& arguments, const std::string& input,
                                const std::function<bool()>& stop, std::size_t kept = std::size_t{64} << 10U);

/// Without its end; of what a program said when it failed.
[[nodiscard]] std::string last_line(std::string text);

/// A word as a shell takes it literally.
[[nodiscard]] std::string shell_quoted(const std::string& word);

}  // namespace amiss::experiment
