#include "dataset/bag_writer.hpp"
#include "fuzz/seeds.hpp"

namespace amiss::fuzz {

namespace {

constexpr std::uint32_t kWidth = 4, kHeight = 3;

test::BagImage image(double stamp_s, const std::string& encoding, std::uint32_t bytes_a_pixel) {
  const std::uint32_t step = kWidth * bytes_a_pixel;
  return {stamp_s, "camera", encoding, kWidth, kHeight, step, std::vector<std::uint8_t>(step * kHeight, 63)};
}

std::string bag(const std::string& compression, const std::string& colour, const std::string& depth) {
  test::BagWriter bag(compression);
  bag.write("/tf_static", test::BagTransform{99.0, "base", "camera", 0.5, 1.0});
  bag.write("/tf", test::BagTransform{99.9, "map", "base", 0.1, 0.0});
  bag.write("/depth/camera_info", test::BagCamera{kWidth, kHeight, 99.0, 10.0, 11.0, 1.5, 1.0});
  bag.write("/rgb/image", image(100.0, colour, colour == "mono8" ? 1 : 3));
  bag.write("/depth/image", image(100.0, depth, depth == "32FC1" ? 4 : 2));
  bag.write("/tf", test::BagTransform{100.1, "map", "base", 0.2, 0.0});
  return bag.bytes();
}

/// Of a robot that stands, with an HSR's topics.
std::string robot_bag() {
  test::BagWriter bag("none");
  bag.write("/tf_static", test::BagPose{99.0, "base_footprint", "laser", 0.2});
  bag.write("/tf_static", test::BagPose{99.0, "base_footprint", "camera", 0.1});
  for (const double t : {100.0, 100.1}) {
    bag.write_odometry("/hsrb/odom", test::BagPose{t, "odom", "base_footprint", 0.1});
    bag.write("/hsrb/base_scan", test::BagScan{t, "laser", -1.0, 0.5, 0.05, 20.0, {1.0F, 2.0F, 3.0F}});
    bag.write("/hsrb/head_rgbd_sensor/depth_registered/camera_info",
              test::BagCamera{kWidth, kHeight, 9, 9, 9, 1.5, 1.0});
    bag.write("/hsrb/head_rgbd_sensor/depth_registered/image_rect_raw", image(t, "16UC1", 2));
  }
  return bag.bytes();
}

}  // namespace

std::vector<std::string> valid_inputs() {
  return {bag("none", "rgb8", "16UC1"), bag("lz4", "bgr8", "32FC1"), bag("bz2", "mono8", "mono16"), robot_bag()};
}

std::vector<std::string> words() {
  return {std::string(4, '\xff'),
          std::string("\x04\0\0\0op=\x05", 8),
          "op=\x02",
          "compression=lz4",
          "compression=bz2",
          "size=\xff\xff\xff\x7f",
          "32FC1",
          "rgb8",
          "sensor_msgs/Image",
          "map",
          "#ROSBAG V2.0\n"};
}

}  // namespace amiss::fuzz
