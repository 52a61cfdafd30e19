// This program run again as a child, with its output kept: what a child does wrong ends the child alone.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace amiss::app {

struct ChildResult {
  int status = 0;  // of its exit; meaningless when it was ended
  int signal = 0;  // that ended it
  bool too_slow = false;
  std::string out, err;
  double wall_s = 0.0;
};

/// Runs `amiss` once for each list of arguments, `parallel` at a time, and hands over each result as it comes (with the
/// index of its arguments). A child that takes longer than the limit is ended. Stops early when interrupted: what runs
/// is ended, what did not begin does not.
void run_children(const std::vector<std::vector<std::string>>& arguments, int parallel, std::chrono::seconds limit,
                  const std::function<void(std::size_t, ChildResult)>& ended);

}  // namespace amiss::app
