#include "mission/odometer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace amiss::mission {
namespace {

constexpr double kPeriod = 0.02;

/// A base that drives curves; what odometry tells is up to the test, the laser knows where the robot is.
struct Ride {
  robot::Limits limits;
  Odometer odometer{limits, HealthParams{}};
  double now_s = 0.0;
  Pose2<Odom, Base> truth;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  double yaw_rate = 0.0;
  bool commanded = true;
  bool laser = true;
  int steps = 0;

  /// `tell`: the true pose at an instant -> what is told of it; nothing: the last told one again.
  void drive(double duration_s, const std::function<std::optional<Odometry>(Stamp, const Pose2<Odom, Base>&)>& tell) {
    const double until_s = now_s + duration_s;
    while (now_s < until_s - 1e-9) {
      now_s += kPeriod;
      robot::Command command;
      if (commanded) {
        command.velocity_base_m_s = {0.25, 0.0};
        command.yaw_rate_rad_s = std::sin(0.5 * now_s);
      }
      velocity.x() += std::clamp(command.velocity_base_m_s.x() - velocity.x(), -0.3 * kPeriod, 0.3 * kPeriod);
      yaw_rate += std::clamp(command.yaw_rate_rad_s - yaw_rate, -2.0 * kPeriod, 2.0 * kPeriod);
      truth = truth * Pose2<Base, Base>{velocity.x() * kPeriod, 0.0, yaw_rate * kPeriod};
      const Stamp now = Stamp{} + duration_of(now_s);
      if (const auto news = tell(now, truth)) told = *news;
      odometer.update(told, now, command);
      if (laser && ++steps % 5 == 0) odometer.compare({truth.x_m, truth.y_m, truth.yaw_rad}, true);
    }
  }
  [[nodiscard]] double error_m() const { return (odometer.pose().position() - truth.position()).norm(); }
  [[nodiscard]] double error_rad() const { return std::abs(wrap_angle(odometer.pose().yaw_rad - truth.yaw_rad)); }
  [[nodiscard]] std::string trouble() const {
    const auto trouble = odometer.trouble(Stamp{} + duration_of(now_s));
    return trouble ? to_string(*trouble) : "none";
  }
  Odometry told;
};

std::optional<Odometry> well(Stamp now, const Pose2<Odom, Base>& truth) { return Odometry{now, truth}; }
std::optional<Odometry> off(Stamp, const Pose2<Odom, Base>&) { return std::nullopt; }

TEST(Odometer, SaysWhatIsToldToTheLastBit) {
  Ride run;
  run.drive(20.0, [&](Stamp now, const Pose2<Odom, Base>& truth) {
    EXPECT_TRUE(run.steps == 0 || run.odometer.pose().x_m == run.told.T_odom_base.x_m);
    return well(now, truth);
  });
  EXPECT_EQ(run.odometer.pose().x_m, run.truth.x_m);
  EXPECT_EQ(run.odometer.pose().yaw_rad, run.truth.yaw_rad);
  EXPECT_EQ(run.odometer.length_factor(), 1.0);
  EXPECT_EQ(run.trouble(), "none");
}

TEST(Odometer, RemembersWhereTheRobotWas) {
  Ride run;
  run.drive(3.0, well);
  const Pose2<Odom, Base> then = run.truth;
  const Stamp stamp = Stamp{} + duration_of(run.now_s);
  run.drive(2.0, well);
  EXPECT_EQ(run.odometer.at(stamp).x_m, then.x_m);
  EXPECT_EQ(run.odometer.at(stamp, {7.0, 0.0, 0.0}).x_m, 7.0) << "what came with a measurement is believed";
  EXPECT_EQ(run.odometer.at(stamp, {std::nan(""), 0.0, 0.0}).x_m, then.x_m);
}

TEST(Odometer, BridgesSilenceWithCommandsAndThenComplains) {
  Ride run;
  run.drive(3.0, well);
  run.drive(1.4, off);
  EXPECT_LT(run.error_m(), 0.01);
  EXPECT_LT(run.error_rad(), 0.01);
  EXPECT_EQ(run.trouble(), "none");
  run.drive(0.3, off);
  EXPECT_EQ(run.trouble(), "odometry silent");
  run.drive(0.1, well);
  EXPECT_EQ(run.trouble(), "none");
  EXPECT_LT(run.error_m(), 1e-9);
}

TEST(Odometer, SetsLateAndSlowOdometryRight) {
  Ride run;
  std::deque<Odometry> late;
  run.drive(5.0, [&](Stamp now, const Pose2<Odom, Base>& truth) {
    late.push_back({now, truth});
    if (late.size() <= 20) return std::optional<Odometry>{};
    const Odometry news = late.front();
    late.pop_front();
    return std::optional<Odometry>{news};
  });
  EXPECT_LT(run.error_m(), 0.01);
  EXPECT_LT(run.error_rad(), 0.01);
}

TEST(Odometer, WhatIsNoNumberIsNotBelieved) {
  Ride run;
  run.drive(3.0, well);
  const auto garbage = [](Stamp now, const Pose2<Odom, Base>&) {
    return std::optional<Odometry>{{now, {40.0, std::nan(""), 1.0}}};
  };
  run.drive(1.0, garbage);
  EXPECT_LT(run.error_m(), 0.01);
  run.drive(1.0, garbage);
  EXPECT_EQ(run.trouble(), "odometry garbage");
  run.drive(0.1, well);
  EXPECT_LT(run.error_m(), 1e-9);
}

TEST(Odometer, ALeapIsNotBelievedOnce) {
  Ride run;
  run.drive(3.0, well);
  bool once = true;
  run.drive(0.1, [&](Stamp now, const Pose2<Odom, Base>& truth) {
    const double leap_m = std::exchange(once, false) ? 50.0 : 0.0;
    EXPECT_LT(run.error_m(), 0.02);
    return std::optional<Odometry>{{now, {truth.x_m + leap_m, truth.y_m, truth.yaw_rad}}};
  });
  EXPECT_LT(run.error_m(), 0.02);
}

TEST(Odometer, GoesByCommandsWhileItIsStuck) {
  Ride run;
  run.drive(3.0, well);
  const Pose2<Odom, Base> stuck = run.truth;
  run.drive(5.0, [&](Stamp now, const Pose2<Odom, Base>&) { return std::optional<Odometry>{{now, stuck}}; });
  EXPECT_TRUE(run.odometer.by_commands());
  EXPECT_LT(run.error_m(), 0.15) << "what had not been noticed";
  const Pose2<Odom, Base> before = run.odometer.pose(), from = run.truth;
  run.drive(1.0, [&](Stamp now, const Pose2<Odom, Base>& truth) {
    return std::optional<Odometry>{{now, stuck * (from.inverse() * truth)}};
  });
  EXPECT_FALSE(run.odometer.by_commands());
  const Pose2<Base, Base> felt = before.inverse() * run.odometer.pose(), real = from.inverse() * run.truth;
  EXPECT_LT((felt.position() - real.position()).norm(), 0.02);
}

TEST(Odometer, ARobotThatIsHeldIsNotMovedByCommands) {
  Ride run;
  run.drive(3.0, well);
  const Pose2<Odom, Base> held = run.truth;
  for (int i = 0; i < 250; ++i) {
    run.now_s += kPeriod;
    robot::Command command;
    command.velocity_base_m_s = {0.25, 0.0};
    run.odometer.update({Stamp{} + duration_of(run.now_s), held}, Stamp{} + duration_of(run.now_s), command);
    run.odometer.compare({held.x_m, held.y_m, held.yaw_rad}, true);
  }
  EXPECT_FALSE(run.odometer.by_commands());
  EXPECT_EQ(run.odometer.pose().x_m, held.x_m);
}

TEST(Odometer, LearnsByWhatFactorItIsWrong) {
  Ride run;
  Pose2<Odom, Base> felt, last;
  const auto wrong = [&](Stamp now, const Pose2<Odom, Base>& truth) {
    const Pose2<Base, Base> motion = last.inverse() * truth;
    last = truth;
    felt = felt * Pose2<Base, Base>{1.33 * motion.x_m, 1.33 * motion.y_m, 1.33 * motion.yaw_rad};
    return std::optional<Odometry>{{now, felt}};
  };
  run.drive(15.0, wrong);
  EXPECT_NEAR(run.odometer.length_factor(), 1.33, 0.04);
  EXPECT_NEAR(run.odometer.turn_factor(), 1.33, 0.04);
  const Pose2<Odom, Base> before = run.odometer.pose(), from = run.truth;
  run.drive(3.0, wrong);
  const Pose2<Base, Base> told = before.inverse() * run.odometer.pose(), real = from.inverse() * run.truth;
  EXPECT_LT((told.position() - real.position()).norm(), 0.06);
}

TEST(Odometer, WithoutTheLaserNothingIsLearned) {
  Ride run;
  run.laser = false;
  const Pose2<Odom, Base> stuck;
  run.drive(5.0, [&](Stamp now, const Pose2<Odom, Base>&) { return std::optional<Odometry>{{now, stuck}}; });
  EXPECT_FALSE(run.odometer.by_commands());
  EXPECT_EQ(run.odometer.pose().x_m, 0.0);
}

}  // namespace
}  // namespace amiss::mission
