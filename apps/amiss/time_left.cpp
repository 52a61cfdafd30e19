#include "time_left.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace amiss::app {

namespace {

using Seconds = std::chrono::duration<double>;
constexpr double kBetweenLines = 60.0;  // s, in a pipe

}  // namespace

std::string duration_text(double seconds_s) {
  if (seconds_s < 100.0) return fmt::format("{:.0f} s", seconds_s);
  if (seconds_s < 6000.0) return fmt::format("{:.0f} min", seconds_s / 60.0);
  return fmt::format("{:.1f} h", seconds_s / 3600.0);
}

TimeLeft::TimeLeft(double guess_s, std::string what)
    : guess_s_(guess_s),
      what_(std::move(what)),
      terminal_(::isatty(STDERR_FILENO) != 0),
      begin_(std::chrono::steady_clock::now()),
      shown_at_(begin_) {}

void TimeLeft::show(std::size_t done, std::size_t of) {
  const auto now = std::chrono::steady_clock::now();
  const bool news = done != shown_ && (done == of || Seconds(now - shown_at_).count() > kBetweenLines);
  if (!terminal_ && !news) return;
  shown_ = done;
  shown_at_ = now;
  const double passed_s = Seconds(now - begin_).count();
  const auto left = static_cast<double>(of - std::min(done, of));
  const double each_s = done > 0 ? passed_s / static_cast<double>(done) : guess_s_;
  const std::string line = fmt::format("{} of {} {}, {} left", done, of, what_, duration_text(left * each_s));
  std::cerr << (terminal_ ? "\r\033[K" + line : "amiss: " + line + "\n") << std::flush;
  dirty_ = terminal_;
}

void TimeLeft::clear() {
  if (dirty_) std::cerr << "\r\033[K" << std::flush;
  dirty_ = false;
}

}  // namespace amiss::app
