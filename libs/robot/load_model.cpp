#include <algorithm>
#include <optional>

#include "core/result.hpp"
#include "robot/internal/urdf_text.hpp"
#include "robot/internal/urdf_tree.hpp"
#include "robot/model.hpp"

namespace amiss::robot {
namespace {

bool contains(const std::string& name, const std::string& part) { return name.find(part) != std::string::npos; }

/// The first that has exactly one of the names, in the order of the names; else the first that `fits`.
template <class Item, class Fits>
std::optional<std::size_t> pick(const std::vector<Item>& items, const std::vector<std::string>& names, Fits fits) {
  for (const std::string& name : names) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (items[i].name == name) return i;
    }
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (fits(items[i].name)) return i;
  }
  return std::nullopt;
}

std::size_t needed(std::optional<std::size_t> found, const std::filesystem::path& urdf, const std::string& what) {
  if (!found) throw InputError(urdf.string() + ": the robot has no " + what);
  return *found;
}

const Joint& head_joint(const Model& model, const std::filesystem::path& urdf, const std::string& part) {
  const auto fits = [&](const std::string& name) { return contains(name, "head") && contains(name, part); };
  const std::string wanted = "head_" + part + "_joint";
  const Joint& joint = model.joints[needed(pick(model.joints, {wanted}, fits), urdf, "joint '" + wanted + "'")];
  if (joint.kind != Joint::Kind::kRevolute) {
    throw InputError(urdf.string() + ": joint '" + joint.name + "' must turn (revolute or continuous)");
  }
  return joint;
}

void take_head(Model& model, const std::filesystem::path& urdf) {
  const Joint& pan = head_joint(model, urdf, "pan");
  const Joint& tilt = head_joint(model, urdf, "tilt");
  model.pan_joint = pan.name;
  model.tilt_joint = tilt.name;
  model.limits.pan_min_rad = pan.lower;
  model.limits.pan_max_rad = pan.upper;
  model.limits.tilt_min_rad = tilt.lower;
  model.limits.tilt_max_rad = tilt.upper;
  const double speed = std::min(pan.velocity, tilt.velocity);
  if (speed > 0.0) model.limits.head_rad_s = speed;
}

void take_camera(Model& model, const std::filesystem::path& urdf) {
  const std::optional<std::size_t> found =
      pick(model.links, {"head_rgbd_sensor_rgb_frame"},
           [](const std::string& name) { return contains(name, "rgbd") && contains(name, "optical"); });
  model.camera_link =
      needed(found ? found : pick(model.links, {"head_rgbd_sensor_link"}, [](const std::string&) { return false; }),
             urdf, "camera frame (head_rgbd_sensor_rgb_frame, *rgbd*optical* or head_rgbd_sensor_link)");
  // Some files give the camera's body (x forward) instead of its optical frame (z forward, y down)
  const Eigen::Matrix3d R = model.link_poses({})[model.camera_link].linear();
  if (R.col(2).x() < 0.5 && R.col(0).x() > 0.5) {
    model.T_link_camera.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  }
}

void take_laser(Model& model, const std::filesystem::path& urdf) {
  const std::size_t laser =
      needed(pick(model.links, {"base_range_sensor_link"},
                  [](const std::string& name) {
                    return contains(name, "laser") || contains(name, "range_sensor") || contains(name, "lidar");
                  }),
             urdf, "laser frame (base_range_sensor_link)");
  model.T_base_laser.T = model.link_poses({})[laser];
}

/// The posture in which the HSR drives: hand across in front of the torso, within the circle of its base.
void take_neutral(Model& model) {
  for (const Joint& joint : model.joints) {
    if (joint.name == "arm_roll_joint" || joint.name == "wrist_flex_joint") model.neutral[joint.name] = -1.57;
  }
}

}  // namespace

Model load_model(const std::filesystem::path& urdf) {
  Model model = read_urdf_tree(load_urdf_text(urdf), urdf);
  model.base_link =
      pick(model.links, {"base_footprint", "base_link"}, [](const std::string&) { return false; }).value_or(0);
  take_neutral(model);
  take_head(model, urdf);
  take_camera(model, urdf);
  take_laser(model, urdf);
  return model;
}

}  // namespace amiss::robot
