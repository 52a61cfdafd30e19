// How far a work of many parts is and how long it will take: one line on a terminal, now and then a line in a pipe.
#pragma once

#include <chrono>
#include <string>

namespace amiss::app {

/// "4 s", "12 min", "3.5 h"
[[nodiscard]] std::string duration_text(double seconds_s);

class TimeLeft {
 public:
  /// `guess_s`: of one, until one is done. `what`: they are called.
  explicit TimeLeft(double guess_s, std::string what = "trials");
  void show(std::size_t done, std::size_t of);
  void clear();

 private:
  double guess_s_;
  std::string what_;
  bool terminal_;
  bool dirty_ = false;
  std::size_t shown_ = 0;
  std::chrono::steady_clock::time_point begin_, shown_at_;
};

}  // namespace amiss::app
