#include "mission/camera_health.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/random.hpp"

namespace amiss::mission {
namespace {

constexpr double kHeight = 1.0, kTilt = radians(32.0);

/// The camera of a robot that looks down ahead.
Transform<Base, Camera> mount() {
  Transform<Base, Camera> T;
  T.T.linear() << 0.0, -std::sin(kTilt), std::cos(kTilt), -1.0, 0.0, 0.0, 0.0, -std::cos(kTilt), -std::sin(kTilt);
  T.T.translation() = Eigen::Vector3d(0.1, 0.0, kHeight);
  return T;
}

/// The floor with noise, and a wall 4 m ahead.
RgbdFrame floor_frame(double at_s, double factor, RandomStream& random) {
  RgbdFrame frame;
  frame.stamp = Stamp{} + duration_of(at_s);
  frame.intrinsics = {160, 120, 135.0, 135.0, 79.5, 59.5};
  const Eigen::Matrix3d R = mount().T.linear();
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const Eigen::Vector3d ray = R * Eigen::Vector3d((u - 79.5) / 135.0, (v - 59.5) / 135.0, 1.0);
      const double floor_m = ray.z() < -1e-6 ? -kHeight / ray.z() : 100.0;
      const double depth_m = std::min(floor_m, 4.0 / ray.x()) * (1.0 + 0.005 * random.normal());
      frame.depth_m.push_back(static_cast<float>(factor * depth_m));
    }
  }
  return frame;
}

/// Five frames a second; the robot drives and turns.
struct Ride {
  RandomStream random{1, "depth"};
  CameraHealth health{HealthParams{}};
  double now_s = 0.0;
  Pose2<Odom, Base> pose;
  bool moves = true;

  bool step(
      double factor = 1.0, const std::function<void(RgbdFrame&)>& spoil = [](RgbdFrame&) {}) {
    now_s += 0.2;
    if (moves) pose = pose * Pose2<Base, Base>{0.06, 0.0, 0.1};
    robot::CapturedFrame captured{floor_frame(now_s, factor, random), mount(), pose};
    spoil(captured.frame);
    return health.accept(captured);
  }
  [[nodiscard]] std::string trouble() const {
    const auto trouble = health.trouble(Stamp{} + duration_of(now_s));
    return trouble ? to_string(*trouble) : "none";
  }
};

TEST(CameraHealth, BelievesAFrameAfterTheOther) {
  Ride run;
  for (int i = 0; i < 60; ++i) EXPECT_TRUE(run.step()) << i;
  EXPECT_EQ(run.trouble(), "none");
}

TEST(CameraHealth, SilenceIsTrouble) {
  Ride run;
  run.step();
  run.now_s += 1.6;
  EXPECT_EQ(run.trouble(), "camera silent");
}

TEST(CameraHealth, ARepeatedFrameIsStuckOnceTheCameraMoved) {
  Ride run;
  std::vector<float> last;
  run.step(1.0, [&](RgbdFrame& frame) { last = frame.depth_m; });
  const auto stuck = [&](RgbdFrame& frame) { frame.depth_m = last; };
  run.moves = false;
  EXPECT_TRUE(run.step(1.0, stuck));
  EXPECT_EQ(run.trouble(), "none");
  run.moves = true;
  EXPECT_FALSE(run.step(1.0, stuck));
  EXPECT_EQ(run.trouble(), "camera stuck");
  EXPECT_TRUE(run.step());
  EXPECT_EQ(run.trouble(), "none");
}

TEST(CameraHealth, NoiseIsGarbage) {
  Ride run;
  const auto noise = [&](RgbdFrame& frame) {
    for (float& d : frame.depth_m) d = static_cast<float>(run.random.uniform(0.0, 8.0));
  };
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(run.step(1.0, noise));
  EXPECT_EQ(run.trouble(), "camera garbage");
}

TEST(CameraHealth, DepthUnderTheFloorIsWrongAndLeftOut) {
  Ride run;
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(run.step(1.2));
  EXPECT_EQ(run.trouble(), "camera wrong");
  EXPECT_TRUE(run.step());
  EXPECT_EQ(run.trouble(), "none");
}

TEST(CameraHealth, DepthThatIsShortWhereverTheRobotLooksIsWrong) {
  Ride run;
  run.moves = false;
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(run.step(0.8));
  EXPECT_EQ(run.trouble(), "none") << "a table may fill the view of who stands before it";
  run.moves = true;
  for (int i = 0; i < 25; ++i) run.step(0.8);
  EXPECT_EQ(run.trouble(), "camera wrong");
}

TEST(FloorScale, IsOneOnTheFloor) {
  RandomStream random(1, "depth");
  const FloorScale scale = floor_scale(floor_frame(0.0, 1.0, random), mount());
  EXPECT_NEAR(scale.median, 1.0, 0.005);
  EXPECT_GT(scale.alike, 0.95);
  EXPECT_LT(scale.too_long, 0.01);
}

TEST(CoherentPart, IsLargeWhereSurfacesAre) {
  RandomStream random(1, "depth");
  EXPECT_GT(coherent_part(floor_frame(0.0, 1.0, random)), 0.95);
  EXPECT_EQ(coherent_part(RgbdFrame{{}, {0, 0, 1.0, 1.0, 0.0, 0.0}, {}, {}}), 1.0) << "nothing says nothing";
}

}  // namespace
}  // namespace amiss::mission
