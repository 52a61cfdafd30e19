#include "page/pace.hpp"

#include <algorithm>

namespace amiss::page {

namespace {

constexpr std::chrono::nanoseconds kLook = std::chrono::milliseconds(50);  // between two looks at `stop`

}  // namespace

void Pace::change(const std::function<void()>& act) {
  const std::lock_guard lock(mutex_);
  act();
  anchored_ = false;
  ++state_.revision;
  changed_.notify_all();
}

void Pace::pause() {
  change([this] {
    state_.paused = true;
    stepping_ = step_wanted_ = false;
  });
}

void Pace::resume() {
  change([this] { state_.paused = stepping_ = step_wanted_ = false; });
}

void Pace::step() {
  change([this] { state_.paused = step_wanted_ = true; });
}

void Pace::set_speed(double times_real) {
  change([&] { state_.speed = std::max(0.0, times_real); });
}

void Pace::release() {
  change([this] {
    state_.paused = stepping_ = step_wanted_ = false;
    state_.speed = 0.0;
  });
}

Pace::State Pace::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

/// How long simulated time has to wait at `now`, as far as is known yet.
std::chrono::nanoseconds Pace::to_wait(Stamp now) {
  if (step_wanted_) {
    step_wanted_ = false;
    stepping_ = true;
    step_until_ = now + kStep;
  }
  if (state_.paused) {
    stepping_ = stepping_ && now < step_until_;
    if (!stepping_) return kLook;
  }
  if (state_.speed <= 0.0) return {};
  if (!anchored_) {
    anchored_ = true;
    anchor_ = {now, Clock::now()};
  }
  const std::chrono::duration<double, std::nano> due = (now - anchor_.simulated) / state_.speed;
  return std::chrono::duration_cast<std::chrono::nanoseconds>(due) - (Clock::now() - anchor_.real);
}

void Pace::wait(Stamp now, const std::function<bool()>& stop) {
  std::unique_lock lock(mutex_);
  while (!stop()) {
    const std::chrono::nanoseconds left = to_wait(now);
    if (left <= std::chrono::nanoseconds::zero()) return;
    changed_.wait_for(lock, std::min(left, kLook));
  }
}

}  // namespace amiss::page
