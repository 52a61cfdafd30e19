// The robot as its URDF describes it: joints with limits, links with collision and visual shapes, where the sensors
// sit. URDF file -> Model; poses in the base frame, metres and radians. InputError names file and element.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/frames.hpp"
#include "robot/robot.hpp"

namespace amiss::robot {

/// One primitive or mesh of a link; dimensions by kind: box x y z, cylinder radius length, sphere radius, mesh scale.
struct LinkShape {
  enum class Kind { kBox, kCylinder, kSphere, kMesh };
  Kind kind = Kind::kBox;
  Eigen::Vector3d dimensions = Eigen::Vector3d::Zero();
  std::filesystem::path mesh;  // kMesh only
  Eigen::Isometry3d T_link_shape = Eigen::Isometry3d::Identity();
  Eigen::Vector4f rgba = Eigen::Vector4f(0.7F, 0.7F, 0.7F, 1.0F);
};

struct Link {
  std::string name;
  std::vector<LinkShape> visuals, collisions;
};

struct Joint {
  enum class Kind { kFixed, kRevolute, kPrismatic };
  std::string name;
  Kind kind = Kind::kFixed;
  std::size_t parent = 0, child = 0;  // indices into links
  Eigen::Isometry3d T_parent_joint = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double lower = 0.0, upper = 0.0, velocity = 0.0;
  std::string mimic;  // name of the joint that this one follows, or ""
  double mimic_multiplier = 1.0, mimic_offset = 0.0;
};

struct Limits {
  double speed_m_s = 0.3;  // navigation
  double acceleration_m_s2 = 0.3;
  double yaw_rate_rad_s = 1.5;
  double yaw_acceleration_rad_s2 = 2.0;
  double head_rad_s = 1.0;
  double pan_min_rad = -3.84, pan_max_rad = 1.75;
  double tilt_min_rad = -1.57, tilt_max_rad = 0.52;
};

class Model {
 public:
  std::string name;
  std::vector<Link> links;    // links[0] is the root of the tree
  std::vector<Joint> joints;  // parents before children
  Limits limits;
  double body_radius_m = 0.23;  // of the base with bumpers
  double navigation_radius_m = 0.30;
  double height_m = 1.1;
  Transform<Base, Laser> T_base_laser;
  CameraIntrinsics camera;
  std::size_t base_link = 0;                                        // index of the link whose frame is the base frame
  std::size_t camera_link = 0;                                      // index of the link that carries the RGB-D camera
  Eigen::Isometry3d T_link_camera = Eigen::Isometry3d::Identity();  // optical frame in that link
  std::string pan_joint = "head_pan_joint", tilt_joint = "head_tilt_joint";
  std::map<std::string, double> neutral;  // positions of joints that nobody commands, 0 for those not in it
  std::vector<std::string> warnings;      // what the file names and is not there, each names file and element

  /// Poses of all links in the base frame for joint positions by name (missing ones: neutral), clamped to the limits.
  [[nodiscard]] std::vector<Eigen::Isometry3d> link_poses(const std::map<std::string, double>& positions) const;
  /// Where the optical frame of the RGB-D camera is for a state of the head.
  [[nodiscard]] Transform<Base, Camera> T_base_camera(const HeadState& head) const;
};

/// Reads a URDF file (not xacro). Understands package:// relative to the file's ancestors, mimic joints without a
/// multiplier, continuous joints with limits (they turn freely), and skips what it does not know. Needs the joints of
/// the head, a frame of the RGB-D camera and one of the laser (InputError naming what is missing).
[[nodiscard]] Model load_model(const std::filesystem::path& urdf);

}  // namespace amiss::robot
