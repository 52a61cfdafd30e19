// Frames that hang on each other and move: what ROS calls tf.
// Transforms with times, in any order -> T_a_b at a time, interpolated between two that are at most 0.5 s apart; fixed
// ones hold at all times. Nothing where the frames do not hang together or nothing is known at that time.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dataset/internal/ros_messages.hpp"

namespace amiss::dataset {

class FrameTree {
 public:
  void add(const RosTransform& transform, bool fixed);
  /// `from` hangs below `to`.
  [[nodiscard]] std::optional<Eigen::Isometry3d> at(const std::string& to, const std::string& from, Stamp stamp) const;
  [[nodiscard]] bool hangs_below(const std::string& from, const std::string& to) const;
  /// All that was said of a frame that hangs on `parent` itself and moves; nothing where it does not.
  [[nodiscard]] std::map<Stamp, Eigen::Isometry3d> motion(const std::string& parent, const std::string& child) const;

 private:
  struct Link {
    std::string parent;
    bool fixed = false;
    std::map<Stamp, Eigen::Isometry3d> T_parent_child;
  };
  [[nodiscard]] static std::optional<Eigen::Isometry3d> link_at(const Link& link, Stamp stamp);
  std::map<std::string, Link> links_;  // by the child's name
};

}  // namespace amiss::dataset
