// One line on a terminal that tells how far a run is; nothing in a pipe.
#pragma once

#include <chrono>
#include <string>

#include "mission/sinks.hpp"

namespace amiss::app {

class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const mission::ProgressEvent& event, const std::string& found);
  /// Any line of a run without simulated time, at most one in half a second.
  void show(const std::string& line);
  void clear();

 private:
  bool on_;
  bool dirty_ = false;
  double shown_at_s_ = -1.0;
  std::chrono::steady_clock::time_point shown_at_{};
};

}  // namespace amiss::app
