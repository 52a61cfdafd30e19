// One line on a terminal that tells how far a run is; nothing in a pipe.
#pragma once

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
  void clear();

 private:
  bool on_;
  bool dirty_ = false;
  double shown_at_s_ = -1.0;
};

}  // namespace amiss::app
