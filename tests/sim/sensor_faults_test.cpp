#include "sim/sensor_faults.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/result.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;
using world::FaultKind;
using world::Sensor;

/// A robot that drives 0.1 m along x in each period of 0.1 s, scans and takes a frame each time.
struct Feed {
  Stamp now{};
  float count = 0.0F;
  robot::Observation next() {
    now += 100ms;
    count += 1.0F;
    robot::Observation seen;
    seen.stamp = now;
    seen.odometry = {now, {0.1 * static_cast<double>(count), 0.0, 0.0}};
    seen.scan = LaserScan{now, 0.0, 0.1, 0.05, 20.0, {count, 2.0F * count}};
    robot::CapturedFrame frame;
    frame.frame = {now, {2, 1, 1, 1, 0, 0}, {{}, {}}, {count, std::nanf("")}};
    frame.T_odom_base = seen.odometry.T_odom_base;
    seen.frame = frame;
    return seen;
  }
};

struct Faults : testing::Test {
  Feed feed;
  SensorFaults faults{1};

  void begin(Sensor sensor, FaultKind kind, double amount = 0.0, double for_s = 1e9) {
    faults.begin({sensor, kind, for_s, amount, {}}, feed.now);
  }
  robot::Observation next() {
    robot::Observation seen = feed.next();
    faults.apply(seen);
    return seen;
  }
  /// In which of ten periods each sensor says something.
  std::string heard(bool camera) {
    std::string text;
    for (int i = 0; i < 10; ++i) {
      const robot::Observation seen = next();
      text += (camera ? seen.frame.has_value() : seen.scan.has_value()) ? 'x' : '.';
    }
    return text;
  }
};

TEST_F(Faults, WithoutAFaultNothingChanges) {
  for (int i = 0; i < 5; ++i) {
    const robot::Observation seen = next();
    EXPECT_NEAR(seen.odometry.T_odom_base.x_m, 0.1 * (i + 1), 1e-12);
    EXPECT_EQ(seen.odometry.stamp, feed.now);
    EXPECT_EQ(seen.scan->ranges_m[0], feed.count);
    EXPECT_EQ(seen.frame->frame.depth_m[0], feed.count);
    EXPECT_NEAR(seen.frame->T_odom_base.x_m, 0.1 * (i + 1), 1e-12);
  }
}

TEST_F(Faults, OffIsSilentForItsTime) {
  begin(Sensor::kCamera, FaultKind::kOff, 0.0, 0.35);
  EXPECT_EQ(heard(true), "...xxxxxxx");
  begin(Sensor::kLaser, FaultKind::kOff);
  EXPECT_EQ(heard(false), "..........");
}

TEST_F(Faults, IntermittentIsGoneAndBackAgain) {
  begin(Sensor::kLaser, FaultKind::kIntermittent, 0.3);
  EXPECT_EQ(heard(false), "..xxx...xx");
}

TEST_F(Faults, SlowSaysLittle) {
  begin(Sensor::kCamera, FaultKind::kSlow, 0.4);
  EXPECT_EQ(heard(true), "x...x...x.");
}

TEST_F(Faults, StuckRepeatsItselfAsIfNew) {
  next();
  begin(Sensor::kLaser, FaultKind::kStuck);
  begin(Sensor::kCamera, FaultKind::kStuck);
  for (int i = 0; i < 3; ++i) {
    const robot::Observation seen = next();
    EXPECT_EQ(seen.scan->ranges_m, (std::vector<float>{1.0F, 2.0F}));
    EXPECT_EQ(seen.scan->stamp, feed.now);
    EXPECT_EQ(seen.frame->frame.depth_m[0], 1.0F);
  }
}

TEST_F(Faults, WrongScalesLengths) {
  begin(Sensor::kLaser, FaultKind::kWrong, 1.5);
  begin(Sensor::kCamera, FaultKind::kWrong, 2.0);
  const robot::Observation seen = next();
  EXPECT_FLOAT_EQ(seen.scan->ranges_m[1], 3.0F);
  EXPECT_FLOAT_EQ(seen.frame->frame.depth_m[0], 2.0F);
}

TEST_F(Faults, GarbageIsWithinTheRangeAndTheSameForASeed) {
  begin(Sensor::kLaser, FaultKind::kGarbage);
  const robot::Observation seen = next();
  for (const float range : seen.scan->ranges_m) EXPECT_TRUE(range >= 0.0F && range <= 20.0F) << range;
  EXPECT_NE(seen.scan->ranges_m[0], 1.0F);
  SensorFaults again(1);
  again.begin({Sensor::kLaser, FaultKind::kGarbage, 1.0, 0.0, {}}, Stamp{});
  robot::Observation same = Feed().next();
  again.apply(same);
  EXPECT_EQ(same.scan->ranges_m, seen.scan->ranges_m);
  begin(Sensor::kOdometry, FaultKind::kGarbage);
  EXPECT_FALSE(std::isfinite(next().odometry.T_odom_base.y_m));
}

TEST_F(Faults, DelayedArrivesLaterWithItsOwnStamp) {
  begin(Sensor::kLaser, FaultKind::kDelayed, 0.25);
  begin(Sensor::kCamera, FaultKind::kDelayed, 0.25);
  begin(Sensor::kOdometry, FaultKind::kDelayed, 0.2);
  EXPECT_FALSE(next().scan);
  EXPECT_FALSE(next().frame);
  EXPECT_FALSE(next().scan);
  const robot::Observation seen = next();
  ASSERT_TRUE(seen.scan && seen.frame);
  EXPECT_EQ(seen.scan->stamp, feed.now - 300ms);
  EXPECT_EQ(seen.frame->frame.stamp, feed.now - 300ms);
  EXPECT_EQ(seen.odometry.stamp, feed.now - 200ms);
  EXPECT_NEAR(seen.odometry.T_odom_base.x_m, 0.2, 1e-12);
}

TEST_F(Faults, OdometryThatIsStuckLosesMotionAndOffDoesNot) {
  next();
  begin(Sensor::kOdometry, FaultKind::kStuck, 0.0, 0.25);
  next();
  EXPECT_NEAR(next().odometry.T_odom_base.x_m, 0.1, 1e-12);
  EXPECT_NEAR(next().odometry.T_odom_base.x_m, 0.2, 1e-12);
  begin(Sensor::kOdometry, FaultKind::kOff, 0.0, 0.25);
  const Stamp last = feed.now;
  next();
  const robot::Observation silent = next();
  EXPECT_EQ(silent.odometry.stamp, last);
  EXPECT_NEAR(silent.odometry.T_odom_base.x_m, 0.2, 1e-12);
  EXPECT_NEAR(next().odometry.T_odom_base.x_m, 0.5, 1e-12);
}

TEST_F(Faults, OdometryThatIsWrongOrJumpsStaysSo) {
  next();
  begin(Sensor::kOdometry, FaultKind::kWrong, 2.0, 0.15);
  EXPECT_NEAR(next().odometry.T_odom_base.x_m, 0.3, 1e-12);
  EXPECT_NEAR(next().odometry.T_odom_base.x_m, 0.4, 1e-12);
  faults.begin({Sensor::kOdometry, FaultKind::kJump, 0.0, 0.0, {0.0, 1.0, 0.0}}, feed.now);
  const robot::Observation seen = next();
  EXPECT_NEAR(seen.odometry.T_odom_base.x_m, 0.5, 1e-12);
  EXPECT_NEAR(seen.odometry.T_odom_base.y_m, 1.0, 1e-12);
  EXPECT_NEAR(seen.frame->T_odom_base.y_m, 1.0, 1e-12) << "frames carry the odometry of their instant";
  EXPECT_THROW(faults.begin({Sensor::kLaser, FaultKind::kJump, 0.0, 0.0, {}}, feed.now), ArgumentError);
}

}  // namespace
}  // namespace amiss::sim
