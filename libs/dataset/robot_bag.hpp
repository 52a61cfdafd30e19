// A ROS 1 bag of a robot that drove with laser, odometry and an RGB-D camera, as what its sensors said in the order of
// their own clock.
//
// in: bag (2.0; plain, bz2 or lz4): nav_msgs/Odometry (where there is none, /tf's odom -> base), sensor_msgs/LaserScan,
// sensor_msgs/Image of registered depth (16UC1 or mono16 in mm, 32FC1 in m) and of colour, or CompressedImage of the
// same topics with /compressedDepth (16UC1) and /compressed behind their names, CameraInfo beside the depth, /tf and
// /tf_static. The topics' defaults are the HSR's.
// out: moments, one for each message of odometry and one for each scan; SI units, NaN where nothing came back, stamps
// from 0 at the first moment. Odometry is interpolated at scans and frames. Scans and frames without odometry round
// them (at most 0.5 s apart), and frames without a place on the robot, are dropped. InputError names the file and what
// is missing (topic, transform) or broken.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/sensors.hpp"

namespace amiss::dataset {

struct RobotBagOptions {
  std::string odometry_topic = "/hsrb/odom", scan_topic = "/hsrb/base_scan";
  std::string depth_topic = "/hsrb/head_rgbd_sensor/depth_registered/image_rect_raw";
  std::string colour_topic = "/hsrb/head_rgbd_sensor/rgb/image_rect_color";
  std::string odom_frame = "odom", base_frame = "base_footprint";
  bool is_odometry_needed = false, is_colour_needed = false;  // InputError where the bag has no such topic
  double frame_period_s = 0.2;                                // frames that come sooner after the last one are left out
};

struct RobotMoment {
  struct Frame {
    RgbdFrame frame;  // without colour where the bag has none of that time
    Transform<Base, Camera> T_base_camera;
    Pose2<Odom, Base> T_odom_base;
  };
  Odometry odometry;              // at this moment
  std::optional<LaserScan> scan;  // of this moment
  std::optional<Frame> frame;     // of between the moment before and this one
};

class RobotBag {
 public:
  explicit RobotBag(const std::filesystem::path& file, const RobotBagOptions& options = {});
  ~RobotBag();
  RobotBag(const RobotBag&) = delete;
  RobotBag& operator=(const RobotBag&) = delete;

  [[nodiscard]] const Transform<Base, Laser>& T_base_laser() const;
  [[nodiscard]] std::size_t dropped() const;  // scans and frames
  /// Nothing at the end.
  std::optional<RobotMoment> next();

  [[nodiscard]] static bool is_bag(const std::filesystem::path& file);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace amiss::dataset
