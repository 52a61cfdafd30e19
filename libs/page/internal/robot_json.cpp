#include "page/internal/robot_json.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::page {

namespace {

using Json = nlohmann::ordered_json;
using Poses = std::vector<Eigen::Isometry3d>;

double rounded(double value) { return std::round(value * 1e4) / 1e4; }
Json vector(const Eigen::Vector3d& v) { return {rounded(v.x()), rounded(v.y()), rounded(v.z())}; }

/// x y z and the quaternion x y z w.
Json pose(const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond q(T.linear());
  const Eigen::Vector3d p = T.translation();
  return {rounded(p.x()), rounded(p.y()), rounded(p.z()), rounded(q.x()),
          rounded(q.y()), rounded(q.z()), rounded(q.w())};
}

const robot::Joint* find(const robot::Model& model, const std::string& name) {
  const auto joint =
      std::find_if(model.joints.begin(), model.joints.end(), [&](const robot::Joint& j) { return j.name == name; });
  return joint == model.joints.end() ? nullptr : &*joint;
}

Json axis_json(const robot::Model& model, const Poses& T_base_link, const std::string& name) {
  const robot::Joint* joint = find(model, name);
  if (joint == nullptr) return nullptr;
  const Eigen::Isometry3d T_base_joint = T_base_link[joint->parent] * joint->T_parent_joint;
  return {{"p", vector(T_base_joint.translation())}, {"axis", vector(T_base_joint.linear() * joint->axis)}};
}

/// Which links hang on a joint; joints come parents before children.
std::vector<bool> below(const robot::Model& model, const std::string& name) {
  std::vector<bool> moved(model.links.size(), false);
  for (const robot::Joint& joint : model.joints) {
    moved[joint.child] = moved[joint.parent] || joint.name == name;
  }
  return moved;
}

std::string_view name_of(robot::LinkShape::Kind kind) {
  switch (kind) {
    case robot::LinkShape::Kind::kBox:
      return "box";
    case robot::LinkShape::Kind::kCylinder:
      return "cylinder";
    case robot::LinkShape::Kind::kSphere:
      return "sphere";
    case robot::LinkShape::Kind::kMesh:
      return "mesh";
  }
  return "";
}

bool is_mesh(const robot::LinkShape& shape) { return shape.kind == robot::LinkShape::Kind::kMesh; }

Json shapes_json(const robot::Link& link, const Eigen::Isometry3d& T_base_link) {
  const bool meshes = std::any_of(link.visuals.begin(), link.visuals.end(), is_mesh);
  Json shapes = Json::array();
  for (const robot::LinkShape& shape : meshes ? link.collisions : link.visuals) {
    if (is_mesh(shape)) continue;
    Json rgb = Json::array();
    for (int i = 0; i < 3; ++i) rgb.push_back(rounded(static_cast<double>(shape.rgba[i])));
    shapes.push_back({{"kind", name_of(shape.kind)},
                      {"size", vector(shape.dimensions)},
                      {"pose", pose(T_base_link * shape.T_link_shape)},
                      {"rgb", std::move(rgb)}});
  }
  return shapes;
}

}  // namespace

Json robot_json(const robot::Model& model) {
  const Poses T_base_link = model.link_poses({{model.pan_joint, 0.0}, {model.tilt_joint, 0.0}});
  const std::vector<bool> pans = below(model, model.pan_joint), tilts = below(model, model.tilt_joint);
  Json links = Json::array();
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    Json shapes = shapes_json(model.links[i], T_base_link[i]);
    if (shapes.empty()) continue;
    const char* part = tilts[i] ? "tilt" : (pans[i] ? "pan" : "body");
    links.push_back({{"name", model.links[i].name}, {"part", part}, {"shapes", std::move(shapes)}});
  }
  const CameraIntrinsics& camera = model.camera;
  return {{"name", model.name},
          {"radius", model.body_radius_m},
          {"links", std::move(links)},
          {"pan", axis_json(model, T_base_link, model.pan_joint)},
          {"tilt", axis_json(model, T_base_link, model.tilt_joint)},
          {"camera", pose(T_base_link.at(model.camera_link) * model.T_link_camera)},
          {"view", {rounded(camera.width / camera.fx), rounded(camera.height / camera.fy)}}};
}

}  // namespace amiss::page
