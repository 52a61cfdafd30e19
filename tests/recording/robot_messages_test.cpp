// What a recording holds of the sensors is what they said, to the last bit.
#include "recording/robot_messages.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <limits>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "recording/ros_messages.hpp"

namespace amiss::recording {
namespace {

double any_number() { return std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>()); }
bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

RC_GTEST_PROP(RobotMessages, ObservationsComeBackBitForBit, ()) {
  robot::Observation o;
  o.stamp = Stamp{std::chrono::nanoseconds(*rc::gen::inRange<std::int64_t>(0, 1'000'000'000'000'000))};
  o.odometry = {o.stamp, {any_number(), any_number(), any_number()}};
  o.head = {any_number(), any_number()};
  o.bumper = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) o.scan = LaserScan{o.stamp, any_number(), any_number(), any_number(), 1.0, {}};
  if (*rc::gen::arbitrary<bool>()) {
    o.frame.emplace().frame.stamp = o.stamp;
    o.frame->T_base_camera.T.translation().x() = any_number();
    o.frame->T_odom_base = {any_number(), 2.0, 3.0};
  }
  const robot::Observation back = parse_observation(observation_message(o));
  RC_ASSERT(back.stamp == o.stamp && back.odometry.stamp == o.stamp && back.bumper == o.bumper);
  RC_ASSERT(same(back.odometry.T_odom_base.x_m, o.odometry.T_odom_base.x_m));
  RC_ASSERT(same(back.odometry.T_odom_base.yaw_rad, o.odometry.T_odom_base.yaw_rad));
  RC_ASSERT(same(back.head.tilt_rad, o.head.tilt_rad));
  RC_ASSERT(back.scan.has_value() == o.scan.has_value() && back.frame.has_value() == o.frame.has_value());
  if (o.scan) RC_ASSERT(same(back.scan->angle_step_rad, o.scan->angle_step_rad));
  if (o.frame) RC_ASSERT(same(back.frame->T_base_camera.T(0, 3), o.frame->T_base_camera.T(0, 3)));
  if (o.frame) RC_ASSERT(same(back.frame->T_odom_base.x_m, o.frame->T_odom_base.x_m));
}

RgbdFrame small_frame() {
  RgbdFrame frame;
  frame.intrinsics = {4, 3, 500.5, 501.25, 1.5, 1.0};
  for (int i = 0; i < 12; ++i) {
    frame.depth_m.push_back(i % 5 == 0 ? std::numeric_limits<float>::quiet_NaN() : 0.1F * static_cast<float>(i));
    frame.colour.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(2 * i), 255});
  }
  return frame;
}

TEST(RobotMessages, ImagesAndRangesComeBackBitForBit) {
  const RgbdFrame frame = small_frame();
  RgbdFrame back;
  parse_camera_info(camera_info_message({}, frame.intrinsics), back.intrinsics);
  parse_depth(depth_message(frame), back);
  parse_colour(colour_message(frame), back);
  EXPECT_EQ(back.intrinsics, frame.intrinsics);
  ASSERT_EQ(back.depth_m.size(), frame.depth_m.size());
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(back.depth_m[i]), std::bit_cast<std::uint32_t>(frame.depth_m[i]));
    EXPECT_EQ(back.colour[i].g, frame.colour[i].g);
  }
  const LaserScan scan{{}, -1.0, 0.01, 0.05, 30.0, {1.0F, 2.5F, 0.1F}};
  LaserScan scan_back;
  parse_ranges(scan_message(scan), scan_back);
  EXPECT_EQ(scan_back.ranges_m, scan.ranges_m);
}

TEST(RobotMessages, CutMessagesAreRefused) {
  const std::string observation = observation_message({}), image = depth_message(small_frame());
  for (std::size_t size = 0; size < observation.size(); ++size) {
    EXPECT_THROW((void)parse_observation(observation.substr(0, size)), InputError) << size;
  }
  for (std::size_t size = 0; size < image.size(); ++size) {
    RgbdFrame frame;
    EXPECT_THROW(parse_depth(image.substr(0, size), frame), InputError) << size;
  }
  RgbdFrame frame = small_frame();
  EXPECT_NE(test::sentence_of<InputError>([&] { parse_depth(colour_message(small_frame()), frame); }).find("32FC1"),
            std::string::npos);
  EXPECT_THROW((void)parse_decision(std::string("\0\1\0\0\7\0\0\0\0\0\0\0", 12)), InputError);
}

TEST(RobotMessages, SetupAndDecisions) {
  recording::Setup setup{~std::uint64_t{0} - 3, "dynamic", {}};
  setup.T_base_laser.T.translation() = Eigen::Vector3d(0.1, 0.2, 0.3);
  const recording::Setup back = parse_setup(setup_message(setup));
  EXPECT_EQ(back.seed, setup.seed);
  EXPECT_EQ(back.method, "dynamic");
  EXPECT_EQ(back.T_base_laser.T.matrix(), setup.T_base_laser.T.matrix());
  const Decision decision = parse_decision(decision_message({Decision::Kind::kExamined, 7}));
  EXPECT_EQ(decision.kind, Decision::Kind::kExamined);
  EXPECT_EQ(decision.region, 7);
}

}  // namespace
}  // namespace amiss::recording
