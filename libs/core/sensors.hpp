// What sensors return. SI units; images row-major, row 0 on top.
#pragma once

#include <cstdint>
#include <vector>

#include "core/frames.hpp"
#include "core/stamp.hpp"

namespace amiss {

/// Pinhole camera without distortion; pixel (u, v) of p_camera is (fx x/z + cx, fy y/z + cy), pixel centres at
/// integers.
struct CameraIntrinsics {
  int width = 640;
  int height = 480;
  double fx = 538.39, fy = 538.09, cx = 315.31, cy = 233.05;  // the calibrated HSR camera, facts in robot_model/
  bool operator==(const CameraIntrinsics&) const = default;
};

/// A colour image with metric depth along the optical axis.
struct RgbdFrame {
  Stamp stamp;
  CameraIntrinsics intrinsics;
  std::vector<Rgb> colour;     // width * height
  std::vector<float> depth_m;  // width * height, along z of the camera; NaN where nothing came back
};

/// One sweep of a planar laser: beam i looks along angle_min_rad + i * angle_step_rad in the laser frame.
struct LaserScan {
  Stamp stamp;
  double angle_min_rad = 0.0;
  double angle_step_rad = 0.0;
  double min_range_m = 0.0, max_range_m = 0.0;
  std::vector<float> ranges_m;  // NaN where nothing came back
};

struct Odometry {
  Stamp stamp;
  Pose2<Odom, Base> T_odom_base;  // integrated, drifts
};

/// Where the robot believes to be, and why that should be believed.
struct PoseEstimate {
  Stamp stamp;
  Pose2<Map, Base> T_map_base;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of x [m], y [m], yaw [rad]
  bool converged = false;
};

}  // namespace amiss
