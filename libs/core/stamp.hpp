// Simulated (or a real robot's) time: chrono nanoseconds since the start of the run. No wall clock.
#pragma once

#include <chrono>

namespace amiss {

struct RunClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<RunClock>;
  static constexpr bool is_steady = true;
};
using Stamp = RunClock::time_point;
using Duration = RunClock::duration;

[[nodiscard]] inline double seconds(Duration d) { return std::chrono::duration<double>(d).count(); }
[[nodiscard]] inline double seconds(Stamp t) { return seconds(t.time_since_epoch()); }
[[nodiscard]] inline Duration duration_of(double seconds_s) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds_s));
}

}  // namespace amiss
