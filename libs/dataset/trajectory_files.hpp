// Poses as text.
//   TUM: "t x y z qx qy qz qw" a line, seconds and metres; '#' begins a comment; times must grow
//   Open3D's .log: a line of three numbers, then a 4 x 4 matrix, and so on
//   a lone 4 x 4 matrix (7-Scenes)
// in: bytes and the name for errors     out: poses of the camera; InputError with name and line for anything else:
// numbers that are missing or not finite, quaternions without length, matrices that are no rigid motion.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/frames.hpp"
#include "core/stamp.hpp"

namespace amiss::dataset {

struct StampedPose {
  Stamp stamp;
  Transform<Map, Camera> T_map_camera;
};

[[nodiscard]] std::vector<StampedPose> parse_tum_trajectory(std::string_view bytes, const std::string& name);
[[nodiscard]] std::string tum_trajectory_bytes(const std::vector<StampedPose>& poses);
[[nodiscard]] std::vector<Transform<Map, Camera>> parse_open3d_log(std::string_view bytes, const std::string& name);
[[nodiscard]] Transform<Map, Camera> parse_pose_matrix(std::string_view bytes, const std::string& name);

/// A part of the way from a to b: 0 is a, 1 is b.
[[nodiscard]] Eigen::Isometry3d between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double part);
/// The pose at the time, between its two neighbours (at most 0.5 s apart); nothing where there are none.
[[nodiscard]] std::optional<Transform<Map, Camera>> pose_at(const std::vector<StampedPose>& poses, Stamp stamp);

}  // namespace amiss::dataset
