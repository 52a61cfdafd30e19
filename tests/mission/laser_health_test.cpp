#include "mission/laser_health.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/random.hpp"

namespace amiss::mission {
namespace {

constexpr int kBeams = 240;

/// In a round room of 3 m with a corner in it, so that turns show; noise of 1 cm.
LaserScan scan_at(double at_s, const Pose2<Odom, Base>& pose, RandomStream& random) {
  LaserScan scan;
  scan.stamp = Stamp{} + duration_of(at_s);
  scan.angle_min_rad = -2.0;
  scan.angle_step_rad = 4.0 / (kBeams - 1);
  scan.max_range_m = 20.0;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = pose.yaw_rad + scan.angle_min_rad + i * scan.angle_step_rad;
    const double wall = std::cos(angle) > 0.5 ? 1.5 : 3.0;
    scan.ranges_m.push_back(static_cast<float>(wall - pose.x_m * std::cos(angle) + 0.01 * random.normal()));
  }
  return scan;
}

/// Ten scans a second; the robot drives and turns.
struct Ride {
  RandomStream random{1, "laser"};
  LaserHealth health{HealthParams{}};
  double now_s = 0.0;
  Pose2<Odom, Base> pose;
  bool moves = true;

  bool step(const std::function<void(LaserScan&)>& spoil = [](LaserScan&) {}) {
    now_s += 0.1;
    if (moves) pose = pose * Pose2<Base, Base>{0.02, 0.0, 0.1};
    LaserScan scan = scan_at(now_s, pose, random);
    spoil(scan);
    return health.accept(scan, pose);
  }
  [[nodiscard]] std::string trouble() const {
    const auto trouble = health.trouble(Stamp{} + duration_of(now_s));
    return trouble ? to_string(*trouble) : "none";
  }
};

TEST(LaserHealth, BelievesAScanAfterTheOther) {
  Ride run;
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(run.step()) << i;
  EXPECT_EQ(run.trouble(), "none");
}

TEST(LaserHealth, SilenceIsTrouble) {
  Ride run;
  run.step();
  run.now_s += 1.4;
  EXPECT_EQ(run.trouble(), "none");
  run.now_s += 0.2;
  EXPECT_EQ(run.trouble(), "laser silent");
}

TEST(LaserHealth, ARepeatedScanIsLeftOutAndStuckOnceTheRobotMoved) {
  Ride run;
  run.step();
  std::vector<float> last;
  run.step([&](LaserScan& scan) { last = scan.ranges_m; });
  const auto stuck = [&](LaserScan& scan) { scan.ranges_m = last; };
  run.moves = false;
  for (int i = 0; i < 40; ++i) EXPECT_FALSE(run.step(stuck));
  EXPECT_EQ(run.trouble(), "none") << "standing still, nothing need change";
  run.moves = true;
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(run.step(stuck));
  EXPECT_EQ(run.trouble(), "laser stuck");
  for (int i = 0; i < 6; ++i) run.step();
  EXPECT_EQ(run.trouble(), "none");
}

TEST(LaserHealth, WhereNothingReturnsNothingIsStuck) {
  Ride run;
  const auto outdoors = [](LaserScan& scan) { scan.ranges_m.assign(kBeams, std::nanf("")); };
  run.step(outdoors);
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(run.step(outdoors)) << i;
  EXPECT_EQ(run.trouble(), "none");
}

TEST(LaserHealth, NoiseIsGarbage) {
  Ride run;
  run.step();
  const auto noise = [&](LaserScan& scan) {
    for (float& r : scan.ranges_m) r = static_cast<float>(run.random.uniform(0.0, 20.0));
  };
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(run.step(noise)) << i;
  EXPECT_EQ(run.trouble(), "laser garbage");
  run.step();
  EXPECT_TRUE(run.step());
  EXPECT_EQ(run.trouble(), "none");
}

TEST(CommonPart, KnowsATurnFromAChange) {
  RandomStream random(1, "laser");
  const LaserScan before = scan_at(0.0, {}, random), turned = scan_at(0.1, {0.0, 0.0, 0.3}, random);
  EXPECT_GT(common_part(before, turned, 0.3), 0.98);
  EXPECT_LT(common_part(before, turned, -0.3), 0.8);
}

}  // namespace
}  // namespace amiss::mission
