// Values of the stages as ROS 2 messages in CDR: what Foxglove, Lichtblick, Rerun and `ros2 bag` read.
// Frames: map, odom, base_link, camera (optical), laser. A depth image is 32FC1 in metres, NaN where nothing came back;
// ranges are NaN there too.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/floor_grid.hpp"
#include "core/sensors.hpp"
#include "knowledge/knowledge_base.hpp"

namespace amiss::recording {

inline constexpr const char *kMapFrame = "map", *kOdomFrame = "odom", *kBaseFrame = "base_link",
                            *kCameraFrame = "camera", *kLaserFrame = "laser";

struct NamedTransform {
  const char *parent, *child;
  Eigen::Isometry3d T_parent_child;
};
[[nodiscard]] std::string transforms_message(Stamp stamp, const std::vector<NamedTransform>& transforms);
[[nodiscard]] std::string odometry_message(const Odometry& odometry);
[[nodiscard]] std::string scan_message(const LaserScan& scan);
[[nodiscard]] std::string depth_message(const RgbdFrame& frame);
[[nodiscard]] std::string colour_message(const RgbdFrame& frame);  // rgb8, as it is
[[nodiscard]] std::string colour_jpeg_message(Stamp stamp, std::string_view jpeg);
[[nodiscard]] std::string camera_info_message(Stamp stamp, const CameraIntrinsics& camera);
[[nodiscard]] std::string grid_message(Stamp stamp, const FloorGrid& grid);
[[nodiscard]] std::string cloud_message(Stamp stamp, std::span<const Eigen::Vector3f> points_map);
[[nodiscard]] std::string path_message(Stamp stamp, const std::vector<Eigen::Vector2d>& points_map);
[[nodiscard]] std::string text_message(std::string_view text);
[[nodiscard]] std::string log_message(Stamp stamp, std::string_view text);
/// Regions as cylinders with their numbers, objects as spheres; replaces what was shown before.
[[nodiscard]] std::string markers_message(Stamp stamp, const knowledge::Knowledge& knowledge);

}  // namespace amiss::recording
