// The messages of ROS 1 that a recording is made of, from their bytes.
// sensor_msgs/Image, CompressedImage, CameraInfo, LaserScan, nav_msgs/Odometry, tf2_msgs/TFMessage (tf/tfMessage) ->
// values; InputError "NAME: ..." for bytes that are none, images whose rows do not fit, rotations without length,
// numbers that are not finite.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/internal/images.hpp"

namespace amiss::dataset {

struct RosHeader {
  Stamp stamp;
  std::string frame;
};
/// The header that Image and CameraInfo begin with.
[[nodiscard]] RosHeader parse_ros_header(std::string_view message, const std::string& name);

/// rgb8, bgr8, rgba8, bgra8, mono8.
[[nodiscard]] ColourImage parse_ros_colour(std::string_view message, const std::string& name);
/// 16UC1 and mono16 (`scale` units are a metre), 32FC1 (metres).
[[nodiscard]] DepthImage parse_ros_depth(std::string_view message, double scale, const std::string& name);
[[nodiscard]] bool is_ros_depth(std::string_view message, const std::string& name);
/// Of a CompressedImage: JPEG or PNG.
[[nodiscard]] ColourImage parse_ros_packed_colour(std::string_view message, const std::string& name);
/// Of a CompressedImage by compressed_depth_image_transport: 16UC1 as PNG.
[[nodiscard]] DepthImage parse_ros_packed_depth(std::string_view message, double scale, const std::string& name);
/// Of the rectified image where the message says it (P), else K.
[[nodiscard]] CameraIntrinsics parse_ros_camera(std::string_view message, const std::string& name);

struct RosTransform {
  Stamp stamp;
  std::string parent, child;  // without a leading '/'
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();
};
[[nodiscard]] std::vector<RosTransform> parse_ros_transforms(std::string_view message, const std::string& name);

struct RosScan {
  std::string frame;
  LaserScan scan;
};
/// Ranges that are none or not between the sensor's least and most are NaN.
[[nodiscard]] RosScan parse_ros_scan(std::string_view message, const std::string& name);

/// What of a pose lies in the plane of the floor.
[[nodiscard]] Pose2<Odom, Base> on_floor(const Eigen::Isometry3d& T_odom_base);
struct RosOdometry {
  std::string parent, child;
  Odometry odometry;
};
[[nodiscard]] RosOdometry parse_ros_odometry(std::string_view message, const std::string& name);

}  // namespace amiss::dataset
