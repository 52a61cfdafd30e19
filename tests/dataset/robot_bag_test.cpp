// Bags of a robot that drives along x with 1 m/s: odometry at 10 Hz, scans and frames between its messages.
#include "dataset/robot_bag.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/files.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "dataset/bag_writer.hpp"
#include "dataset/internal/images.hpp"

namespace amiss::dataset {
namespace {

constexpr const char *kBase = "base_footprint", *kRgbd = "/hsrb/head_rgbd_sensor/";

test::BagPose turned(double stamp_s, const char* parent, const char* child, double x_m, double yaw_rad) {
  return {stamp_s, parent, child, x_m, 0.0, 0.0, 0.0, 0.0, std::sin(yaw_rad / 2.0), std::cos(yaw_rad / 2.0)};
}

struct Contents {
  std::string compression = "none";
  bool odometry = true, colours = true, laser_frame = true;
  std::string packed = {};  // format of packed depth; then colours are packed too
  double frame_step_s = 0.1, scans_late_s = 0.0;
};

constexpr const char *kDepth = "/hsrb/head_rgbd_sensor/depth_registered/image_rect_raw",
                     *kColour = "/hsrb/head_rgbd_sensor/rgb/image_rect_color";

/// Depths of 1 m, none, 1 mm, none...; a grey of 9.
void write_images(test::BagWriter& bag, double t, bool colours) {
  bag.write(kDepth, test::BagImage{t, "camera", "16UC1", 4, 2, 8, {0xe8, 3, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}});
  if (!colours) return;
  bag.write(kColour, test::BagImage{t + 0.004, "camera", "rgb8", 4, 2, 12, std::vector<std::uint8_t>(24, 9)});
}

void write_packed(test::BagWriter& bag, double t, const std::string& format) {
  const std::string depth = depth_png_bytes({1.0F, 0, 0.001F, 0, 0, 0, 0, 0}, 4, 2, 1000.0);
  const std::string colour = png_bytes(std::vector<Rgb>(8, Rgb{9, 9, 9}), 4, 2);
  bag.write(std::string(kDepth) + "/compressedDepth",
            test::BagPacked{t, "camera", format, std::string(12, '\0') + depth});
  bag.write(std::string(kColour) + "/compressed", test::BagPacked{t + 0.004, "camera", "rgb8; png compressed", colour});
}

/// The head hangs on a torso that hangs on the base and turns by 1 rad/s.
std::string bag_bytes(const Contents& contents) {
  test::BagWriter bag(contents.compression);
  if (contents.laser_frame) bag.write("/tf_static", turned(90.0, kBase, "laser", 0.25, 0.0));
  bag.write("/tf_static", turned(90.0, kBase, "torso", 0.0, M_PI_2));
  bag.write(std::string(kRgbd) + "depth_registered/camera_info", test::BagCamera{4, 2, 5.0, 5.0, 5.0, 1.5, 0.5});
  bag.write("/hand_camera/camera_info", test::BagCamera{4, 2});  // never calibrated, and not asked for
  for (int i = 0; i <= 10; ++i) {
    const double t = 100.0 + 0.1 * i;
    bag.write("/tf", turned(t, "torso", "camera", 0.0, 0.1 * i));
    contents.odometry ? bag.write_odometry("/hsrb/odom", turned(t, "odom", kBase, 0.1 * i, 3.1 + 0.02 * i))
                      : bag.write("/tf", turned(t, "odom", kBase, 0.1 * i, 3.1 + 0.02 * i));
    bag.write("/hsrb/base_scan", test::BagScan{t + 0.025 + contents.scans_late_s,
                                               "laser",
                                               -1.0,
                                               0.5,
                                               0.05,
                                               20.0,
                                               {1.5F, 0.01F, 25.0F, std::numeric_limits<float>::infinity()}});
  }
  for (double t = 100.05; t < 101.0; t += contents.frame_step_s) {
    contents.packed.empty() ? write_images(bag, t, contents.colours) : write_packed(bag, t, contents.packed);
  }
  return bag.bytes();
}

struct RobotBagTest : testing::Test {
  test::TemporaryFolder folder;

  [[nodiscard]] std::filesystem::path written(const Contents& contents) const {
    return folder.write("a.bag", bag_bytes(contents));
  }
  static std::vector<RobotMoment> moments(const std::filesystem::path& file, const RobotBagOptions& options = {}) {
    RobotBag bag(file, options);
    std::vector<RobotMoment> all;
    while (auto moment = bag.next()) all.push_back(std::move(*moment));
    return all;
  }
  [[nodiscard]] std::string why(const Contents& contents, const RobotBagOptions& options = {}) const {
    return test::sentence_of<InputError>([&] { (void)moments(written(contents), options); });
  }
};

TEST_F(RobotBagTest, MomentsAreOdometryAndScansInTheOrderOfTheClock) {
  for (const char* compression : {"none", "lz4", "bz2"}) {
    const auto all = moments(written({.compression = compression}));
    ASSERT_EQ(all.size(), 21U) << "the scan after the last odometry is dropped";
    EXPECT_EQ(all[0].odometry.stamp, Stamp{});
    EXPECT_FALSE(all[0].scan);
    EXPECT_NEAR(seconds(all[1].odometry.stamp), 0.025, 1e-6);
    EXPECT_NEAR(all[1].odometry.T_odom_base.x_m, 0.025, 1e-6) << "between two messages";
    EXPECT_NEAR(all[5].odometry.T_odom_base.yaw_rad, wrap_angle(3.1 + 0.02 * 2.25), 1e-6) << "over the cut at pi";
    const LaserScan& scan = all[1].scan.value();
    EXPECT_EQ(scan.stamp, all[1].odometry.stamp);
    EXPECT_NEAR(scan.angle_step_rad, 0.5, 1e-9);
    EXPECT_EQ(scan.ranges_m[0], 1.5F);
    for (int beam : {1, 2, 3}) EXPECT_TRUE(std::isnan(scan.ranges_m[static_cast<std::size_t>(beam)])) << beam;
  }
}

TEST_F(RobotBagTest, FramesComeWithTheirPlaceOnTheRobotAtTheirOwnTime) {
  const auto file = written({});
  RobotBag bag(file);
  EXPECT_EQ(bag.T_base_laser().position(), Eigen::Vector3d(0.25, 0.0, 0.0));
  EXPECT_EQ(bag.dropped(), 1U);
  const auto all = moments(file, {.frame_period_s = 0.0});
  ASSERT_TRUE(all[2].frame) << "taken at 0.05 s, told with the odometry of 0.1 s";
  const auto& [frame, T_base_camera, T_odom_base] = *all[2].frame;
  EXPECT_NEAR(seconds(frame.stamp), 0.05, 1e-6);
  EXPECT_EQ(frame.depth_m[0], 1.0F);
  EXPECT_TRUE(std::isnan(frame.depth_m[1]));
  EXPECT_EQ(frame.depth_m[2], 0.001F);
  EXPECT_TRUE(frame.colour.at(7) == (Rgb{9, 9, 9}));
  EXPECT_NEAR(T_odom_base.x_m, 0.05, 1e-6);
  const Eigen::AngleAxisd turn(T_base_camera.T.linear());
  EXPECT_NEAR(turn.angle(), M_PI_2 + 0.05, 1e-6) << "between two transforms, and the torso's";
}

TEST_F(RobotBagTest, PackedImagesAreReadWhereThereAreNoOthers) {
  const auto all = moments(written({.packed = "16UC1; compressedDepth png"}));
  const RgbdFrame& frame = all.at(2).frame.value().frame;
  EXPECT_EQ(frame.depth_m[0], 1.0F);
  EXPECT_TRUE(std::isnan(frame.depth_m[1]));
  EXPECT_EQ(frame.depth_m[2], 0.001F);
  EXPECT_TRUE(frame.colour.at(7) == (Rgb{9, 9, 9}));
  const std::string said = why({.packed = "32FC1; compressedDepth"});
  EXPECT_NE(said.find("depth is packed as '32FC1; compressedDepth'; '16UC1; compressedDepth' (png) is allowed"),
            std::string::npos)
      << said;
}

TEST_F(RobotBagTest, FramesThatComeTooSoonAreLeftOut) {
  const auto count = [file = written({})](const RobotBagOptions& options) {
    const auto all = moments(file, options);
    return std::count_if(all.begin(), all.end(), [](const RobotMoment& m) { return m.frame.has_value(); });
  };
  EXPECT_EQ(count({}), 5);
  EXPECT_EQ(count({.frame_period_s = 0.0}), 10);
}

TEST_F(RobotBagTest, WithoutOdometryTheTransformsAreTakenAndWithoutColoursNone) {
  const auto all = moments(written({.odometry = false, .colours = false}));
  ASSERT_EQ(all.size(), 21U);
  EXPECT_NEAR(all[1].odometry.T_odom_base.x_m, 0.025, 1e-6);
  EXPECT_TRUE(all[2].frame.value().frame.colour.empty());
}

TEST_F(RobotBagTest, SaysWhatIsMissing) {
  const auto says = [](const std::string& said, const char* words) {
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  says(why({}, {.scan_topic = "/scan"}), "has no topic '/scan' of sensor_msgs/LaserScan; there are: /hsrb/base_scan");
  says(why({}, {.odometry_topic = "/odom"}),
       "has no topic '/odom' of nav_msgs/Odometry, and /tf does not move 'base_footprint' in 'odom'");
  says(why({}, {.odometry_topic = "/odom", .is_odometry_needed = true}),
       "has no topic '/odom' of nav_msgs/Odometry; there are: /hsrb/odom");
  says(why({}, {.colour_topic = "/rgb", .is_colour_needed = true}),
       "has no topic '/rgb' of sensor_msgs/Image; there are");
  says(why({.colours = false}, {.is_colour_needed = true}), "of sensor_msgs/Image; there is none of that type");
  says(why({}, {.depth_topic = "/hsrb/head_rgbd_sensor/rgb/image_rect_color"}), "of sensor_msgs/Image (16UC1");
  says(why({.laser_frame = false}), "do not say where the frame 'laser' is in 'base_footprint'");
  says(why({}, {.base_frame = "base_link"}), "do not say where the frame 'laser' is in 'base_link'");
  says(why({.scans_late_s = 3600.0}), "no scan lies in the time of its odometry and transforms");
  EXPECT_FALSE(RobotBag::is_bag(folder.write("b", "x")));
}

}  // namespace
}  // namespace amiss::dataset
