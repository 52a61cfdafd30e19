#include "page/pace.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace amiss::page {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod = 20ms;
const auto kNever = [] { return false; };

/// A run that asks at each period, in a thread of its own.
class Asking {
 public:
  explicit Asking(Pace& pace)
      : thread_([this, &pace] {
          for (Stamp now; !stop_; now += kPeriod) {
            pace.wait(now, [this] { return stop_.load(); });
            ++periods_;
          }
        }) {}
  ~Asking() {
    stop_ = true;
    thread_.join();
  }
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;
  [[nodiscard]] long periods() const { return periods_; }
  [[nodiscard]] bool reaches(long periods) const {
    for (int i = 0; i < 500 && periods_ < periods; ++i) std::this_thread::sleep_for(10ms);
    return periods_ >= periods;
  }

 private:
  std::atomic<bool> stop_ = false;
  std::atomic<long> periods_ = 0;
  std::thread thread_;
};

double took_s(const std::function<void()>& act) {
  const auto begin = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(Pace, LetsARunGoAsFastAsItCan) {
  Pace pace;
  EXPECT_LT(took_s([&] {
              for (Stamp now; now < Stamp(1h); now += kPeriod) pace.wait(now, kNever);
            }),
            5.0);
}

TEST(Pace, HoldsTheSpeed) {
  Pace pace;
  pace.set_speed(10.0);
  const double took = took_s([&] {
    for (Stamp now; now <= Stamp(2s); now += kPeriod) pace.wait(now, kNever);
  });
  EXPECT_GE(took, 0.199);
  EXPECT_LT(took, 2.0);
}

TEST(Pace, PausesAndGoesOn) {
  Pace pace;
  pace.pause();
  EXPECT_TRUE(pace.state().paused);
  const Asking run(pace);
  std::this_thread::sleep_for(150ms);
  EXPECT_EQ(run.periods(), 0);
  pace.resume();
  EXPECT_TRUE(run.reaches(100));
}

TEST(Pace, StepsAreOfOneLength) {
  Pace pace;
  pace.pause();
  const Asking run(pace);
  for (long steps = 1; steps <= 3; ++steps) {
    pace.step();
    EXPECT_TRUE(run.reaches(steps * (Pace::kStep / kPeriod)));
    std::this_thread::sleep_for(120ms);
    EXPECT_EQ(run.periods(), steps * (Pace::kStep / kPeriod));
  }
  EXPECT_TRUE(pace.state().paused);
}

TEST(Pace, ReleaseForgetsAll) {
  Pace pace;
  pace.set_speed(0.01);
  pace.pause();
  const int before = pace.state().revision;
  pace.release();
  EXPECT_FALSE(pace.state().paused);
  EXPECT_EQ(pace.state().speed, 0.0);
  EXPECT_GT(pace.state().revision, before);
}

TEST(Pace, StopsWhilePaused) {
  Pace pace;
  pace.pause();
  EXPECT_LT(took_s([&] { pace.wait(Stamp{}, [] { return true; }); }), 1.0);
}

}  // namespace
}  // namespace amiss::page
