#include "sim/motors.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "core/random.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;

RC_GTEST_PROP(Motors, NoCommandBreaksALimit, (std::uint64_t seed)) {
  RandomStream random(seed, "commands");
  const robot::Limits limits;
  Motors motors(limits);
  const double slack = 1.0 + 1e-9, dt_s = 0.02;
  for (int i = 0; i < 300; ++i) {
    robot::Command command;
    command.velocity_base_m_s = {random.uniform(-2, 2), random.uniform(-2, 2)};
    command.yaw_rate_rad_s = random.uniform(-5, 5);
    command.pan_rad = random.uniform(-6, 6);
    command.tilt_rad = random.uniform(-3, 3);
    const Motors before = motors;
    motors.step(command, 20ms);
    RC_ASSERT(motors.velocity_base_m_s().norm() <= limits.speed_m_s * slack);
    RC_ASSERT((motors.velocity_base_m_s() - before.velocity_base_m_s()).norm() <=
              limits.acceleration_m_s2 * dt_s * slack);
    RC_ASSERT(std::abs(motors.yaw_rate_rad_s()) <= limits.yaw_rate_rad_s * slack);
    RC_ASSERT(std::abs(motors.yaw_rate_rad_s() - before.yaw_rate_rad_s()) <=
              limits.yaw_acceleration_rad_s2 * dt_s * slack);
    RC_ASSERT(std::abs(motors.head().pan_rad - before.head().pan_rad) <= limits.head_rad_s * dt_s * slack);
    RC_ASSERT(std::abs(motors.head().tilt_rad - before.head().tilt_rad) <= limits.head_rad_s * dt_s * slack);
    RC_ASSERT(motors.head().pan_rad >= limits.pan_min_rad && motors.head().pan_rad <= limits.pan_max_rad);
    RC_ASSERT(motors.head().tilt_rad >= limits.tilt_min_rad && motors.head().tilt_rad <= limits.tilt_max_rad);
  }
}

TEST(Motors, ReachesWhatIsCommandedAndStaysThere) {
  Motors motors{robot::Limits{}};
  robot::Command command;
  command.velocity_base_m_s = {0.2, -0.1};
  command.yaw_rate_rad_s = 0.5;
  command.tilt_rad = -0.55;
  for (int i = 0; i < 100; ++i) motors.step(command, 20ms);
  EXPECT_NEAR((motors.velocity_base_m_s() - command.velocity_base_m_s).norm(), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(motors.yaw_rate_rad_s(), 0.5);
  EXPECT_DOUBLE_EQ(motors.head().tilt_rad, -0.55);
}

TEST(Motors, ACommandThatIsNoNumberMeansStop) {
  Motors motors{robot::Limits{}};
  robot::Command command;
  command.velocity_base_m_s = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  command.yaw_rate_rad_s = std::numeric_limits<double>::quiet_NaN();
  motors.step(command, 20ms);
  EXPECT_EQ(motors.velocity_base_m_s().norm(), 0.0);
  EXPECT_EQ(motors.yaw_rate_rad_s(), 0.0);
}

TEST(Motors, ConstantTurningDrivesACircle) {
  Motors motors{robot::Limits{}};
  motors.held({0.3, 0}, 0.6);
  Pose2<amiss::World, Base> pose;
  const int steps = static_cast<int>(std::lround(2.0 * std::numbers::pi / (0.6 * 0.02)));
  double farthest = 0.0;
  for (int i = 0; i < steps; ++i) {
    pose = motors.advanced(pose, 20ms);
    farthest = std::max(farthest, pose.position().norm());
  }
  EXPECT_NEAR(farthest, 1.0, 1e-3);  // the diameter 2 * 0.3 / 0.6
  EXPECT_LT(pose.position().norm(), 0.01);
}

}  // namespace
}  // namespace amiss::sim
