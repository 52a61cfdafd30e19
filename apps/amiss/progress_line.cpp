#include "progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

namespace amiss::app {

ProgressLine::ProgressLine(bool wanted) : on_(wanted && ::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const mission::ProgressEvent& event, const std::string& found) {
  if (!on_ || seconds(event.stamp) < shown_at_s_ + 1.0) return;
  shown_at_s_ = seconds(event.stamp);
  std::cerr << fmt::format("\r\033[K{:5.0f} s   {:5.1f} m2 seen   {} regions   {} examined   {}", shown_at_s_,
                           event.seen_m2, event.regions, event.examined, found)
            << std::flush;
  dirty_ = true;
}

void ProgressLine::show(const std::string& line) {
  const auto now = std::chrono::steady_clock::now();
  if (!on_ || now - shown_at_ < std::chrono::milliseconds(500)) return;
  shown_at_ = now;
  std::cerr << "\r\033[K" << line << std::flush;
  dirty_ = true;
}

void ProgressLine::clear() {
  if (dirty_) std::cerr << "\r\033[K" << std::flush;
  dirty_ = false;
}

}  // namespace amiss::app
