// How fast simulated time may pass while somebody watches: as fast as possible, at a multiple of real time, paused, or
// a step at a time. The run's thread asks at every control period; pages set it from other threads. It changes when
// things are computed, never what.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

#include "core/stamp.hpp"

namespace amiss::page {

class Pace {
 public:
  static constexpr Duration kStep = std::chrono::milliseconds(200);

  /// Waits until simulated time may go on from `now`, or `stop` says so (asked every 50 ms at least).
  void wait(Stamp now, const std::function<bool()>& stop);

  void pause();
  void resume();
  void step();                        // lets kStep pass, then pauses
  void set_speed(double times_real);  // 0: as fast as possible
  void release();                     // nobody watches any more: as fast as possible, not paused

  struct State {
    bool paused = false;
    double speed = 0.0;
    int revision = 0;  // grows with every change
  };
  [[nodiscard]] State state() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Anchor {
    Stamp simulated;
    Clock::time_point real;
  };
  void change(const std::function<void()>& act);
  [[nodiscard]] std::chrono::nanoseconds to_wait(Stamp now);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  State state_;
  bool step_wanted_ = false;
  Stamp step_until_;
  bool stepping_ = false;
  bool anchored_ = false;
  Anchor anchor_;
};

}  // namespace amiss::page
