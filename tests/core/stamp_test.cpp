#include "core/stamp.hpp"

#include <gtest/gtest.h>

namespace amiss {
namespace {

TEST(Stamp, SecondsAndBack) {
  EXPECT_EQ(duration_of(0.02).count(), 20'000'000);
  EXPECT_DOUBLE_EQ(seconds(duration_of(1.5)), 1.5);
  const Stamp start{};
  EXPECT_DOUBLE_EQ(seconds(start + duration_of(2.25)), 2.25);
}

TEST(Stamp, ControlPeriodsAddUpExactly) {
  Stamp now{};
  for (int i = 0; i < 50 * 3600; ++i) now += duration_of(0.02);
  EXPECT_EQ(now.time_since_epoch(), std::chrono::hours(1));
}

}  // namespace
}  // namespace amiss
