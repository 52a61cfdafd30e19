#include "robot/model.hpp"

#include <algorithm>

namespace amiss::robot {
namespace {

constexpr int kMaxMimicDepth = 8;

const Joint* find_joint(const std::vector<Joint>& joints, const std::string& name) {
  const auto found = std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) { return joint.name == name; });
  return found != joints.end() ? &*found : nullptr;
}

double position_of(const Model& model, const Joint& joint, const std::map<std::string, double>& positions,
                   int depth = 0) {
  double value = 0.0;
  const Joint* followed = joint.mimic.empty() ? nullptr : find_joint(model.joints, joint.mimic);
  if (followed != nullptr && depth < kMaxMimicDepth) {
    value = joint.mimic_multiplier * position_of(model, *followed, positions, depth + 1) + joint.mimic_offset;
  } else {
    const auto given = positions.find(joint.name), neutral = model.neutral.find(joint.name);
    if (neutral != model.neutral.end()) value = neutral->second;
    if (given != positions.end()) value = given->second;
  }
  return std::clamp(value, joint.lower, joint.upper);
}

Eigen::Isometry3d motion_of(const Joint& joint, double position) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  switch (joint.kind) {
    case Joint::Kind::kFixed:
      break;
    case Joint::Kind::kRevolute:
      T.rotate(Eigen::AngleAxisd(position, joint.axis));
      break;
    case Joint::Kind::kPrismatic:
      T.translate(position * joint.axis);
      break;
  }
  return T;
}

}  // namespace

std::vector<Eigen::Isometry3d> Model::link_poses(const std::map<std::string, double>& positions) const {
  std::vector<Eigen::Isometry3d> T_root_link(links.size(), Eigen::Isometry3d::Identity());
  for (const Joint& joint : joints) {
    const double position = joint.kind == Joint::Kind::kFixed ? 0.0 : position_of(*this, joint, positions);
    T_root_link[joint.child] = T_root_link[joint.parent] * joint.T_parent_joint * motion_of(joint, position);
  }
  if (base_link != 0 && base_link < links.size()) {
    const Eigen::Isometry3d T_base_root = T_root_link[base_link].inverse();
    for (Eigen::Isometry3d& T : T_root_link) T = T_base_root * T;
  }
  return T_root_link;
}

Transform<Base, Camera> Model::T_base_camera(const HeadState& head) const {
  const std::vector<Eigen::Isometry3d> T_base_link =
      link_poses({{pan_joint, head.pan_rad}, {tilt_joint, head.tilt_rad}});
  return {T_base_link.at(camera_link) * T_link_camera};
}

}  // namespace amiss::robot
