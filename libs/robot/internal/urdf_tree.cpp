#include "robot/internal/urdf_tree.hpp"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>

#include "core/result.hpp"
#include "robot/internal/mesh_path.hpp"

namespace amiss::robot {
namespace {

/// Keeps the first error that the parser would otherwise print.
class FirstError : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && message.empty()) message = text;
  }
  std::string message;
};

urdf::ModelInterfaceSharedPtr parse(const std::string& text, const std::string& file) {
  static std::mutex one_at_a_time;  // the parser's output handler is one for the process
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  FirstError errors;
  console_bridge::useOutputHandler(&errors);
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(text);
  } catch (const std::exception& error) {
    errors.message = error.what();
  }
  console_bridge::restorePreviousOutputHandler();
  if (model == nullptr || model->getRoot() == nullptr) {
    std::replace(errors.message.begin(), errors.message.end(), '\n', ' ');
    throw InputError(file + ": not a URDF that can be read (" +
                     (errors.message.empty() ? "is it cut short?" : errors.message) + ")");
  }
  return model;
}

Eigen::Isometry3d isometry_of(const urdf::Pose& pose) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translate(Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z));
  const Eigen::Quaterniond q(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  T.rotate(q.normalized());
  return T;
}

class TreeReader {
 public:
  TreeReader(const urdf::ModelInterface& source, const std::filesystem::path& urdf) : source_(source), urdf_(urdf) {}

  Model run() {
    model_.name = source_.getName();
    add_link(*source_.getRoot());
    std::set<std::string> seen = {source_.getRoot()->name};
    for (std::size_t i = 0; i < model_.links.size(); ++i) {
      const urdf::LinkConstSharedPtr link = source_.getLink(model_.links[i].name);
      if (link == nullptr) continue;
      std::vector<urdf::JointSharedPtr> joints = link->child_joints;
      std::sort(joints.begin(), joints.end(), [](const auto& a, const auto& b) { return a->name < b->name; });
      for (const urdf::JointSharedPtr& joint : joints) {
        if (!seen.insert(joint->child_link_name).second) {
          throw fault("joint '" + joint->name + "' gives link '" + joint->child_link_name +
                      "' a second parent; links must form a tree");
        }
        add_joint(*joint, i);
      }
    }
    if (model_.links.size() != source_.links_.size()) {
      throw fault("only " + std::to_string(model_.links.size()) + " of " + std::to_string(source_.links_.size()) +
                  " links hang together; links must form one tree");
    }
    return std::move(model_);
  }

 private:
  InputError fault(const std::string& what) const { return InputError(urdf_.string() + ": " + what); }

  Eigen::Isometry3d finite(const urdf::Pose& pose, const std::string& of) const {
    const Eigen::Isometry3d T = isometry_of(pose);
    if (!T.matrix().allFinite()) throw fault("the origin of '" + of + "' is not finite");
    return T;
  }

  void add_joint(const urdf::Joint& source, std::size_t parent) {
    const urdf::LinkConstSharedPtr child = source_.getLink(source.child_link_name);
    if (child == nullptr) throw fault("joint '" + source.name + "' names a link that is not there");
    Joint joint;
    joint.name = source.name;
    joint.parent = parent;
    joint.child = model_.links.size();
    joint.T_parent_joint = finite(source.parent_to_joint_origin_transform, source.name);
    take_kind(source, joint);
    if (source.mimic != nullptr) {
      joint.mimic = source.mimic->joint_name;
      joint.mimic_multiplier = source.mimic->multiplier;
      joint.mimic_offset = source.mimic->offset;
    }
    if (joint.kind != Joint::Kind::kFixed) take_axis(source, joint);
    model_.joints.push_back(std::move(joint));
    add_link(*child);
  }

  void take_kind(const urdf::Joint& source, Joint& joint) {
    switch (source.type) {
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS:
        joint.kind = Joint::Kind::kRevolute;
        break;
      case urdf::Joint::PRISMATIC:
        joint.kind = Joint::Kind::kPrismatic;
        break;
      case urdf::Joint::FIXED:
        break;
      case urdf::Joint::UNKNOWN:
      case urdf::Joint::FLOATING:
      case urdf::Joint::PLANAR:
        model_.warnings.push_back(urdf_.string() + ": joint '" + source.name + "' is taken as fixed");
        break;
    }
    if (source.limits != nullptr) joint.velocity = source.limits->velocity;
    if (source.type == urdf::Joint::CONTINUOUS) {
      joint.lower = -std::numeric_limits<double>::infinity();
      joint.upper = std::numeric_limits<double>::infinity();
    } else if (source.limits != nullptr) {
      joint.lower = source.limits->lower;
      joint.upper = source.limits->upper;
      if (!(joint.lower <= joint.upper)) {
        throw fault("joint '" + source.name + "' has a lower limit above its upper one");
      }
    }
  }

  void take_axis(const urdf::Joint& source, Joint& joint) const {
    const Eigen::Vector3d axis(source.axis.x, source.axis.y, source.axis.z);
    if (!axis.allFinite() || axis.norm() < 1e-9) throw fault("joint '" + source.name + "' has no axis");
    joint.axis = axis.normalized();
  }

  void add_link(const urdf::Link& source) {
    Link link;
    link.name = source.name;
    for (const urdf::VisualSharedPtr& visual : source.visual_array) {
      if (visual == nullptr || visual->geometry == nullptr) continue;
      LinkShape shape;
      if (visual->material != nullptr) {
        const urdf::Color& c = visual->material->color;
        shape.rgba = Eigen::Vector4f(c.r, c.g, c.b, c.a).cwiseMax(0.0F).cwiseMin(1.0F);
      }
      shape.T_link_shape = finite(visual->origin, source.name);
      if (take_geometry(*visual->geometry, source.name, shape)) link.visuals.push_back(shape);
    }
    for (const urdf::CollisionSharedPtr& collision : source.collision_array) {
      if (collision == nullptr || collision->geometry == nullptr) continue;
      LinkShape shape;
      shape.T_link_shape = finite(collision->origin, source.name);
      if (take_geometry(*collision->geometry, source.name, shape)) link.collisions.push_back(shape);
    }
    model_.links.push_back(std::move(link));
  }

  /// False (with a warning) for what cannot be used.
  bool take_geometry(const urdf::Geometry& source, const std::string& link, LinkShape& shape) {
    if (const auto* box = dynamic_cast<const urdf::Box*>(&source)) {
      shape.kind = LinkShape::Kind::kBox;
      shape.dimensions = {box->dim.x, box->dim.y, box->dim.z};
    } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&source)) {
      shape.kind = LinkShape::Kind::kCylinder;
      shape.dimensions = {cylinder->radius, cylinder->length, 0.0};
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&source)) {
      shape.kind = LinkShape::Kind::kSphere;
      shape.dimensions = {sphere->radius, 0.0, 0.0};
    } else if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(&source)) {
      shape.kind = LinkShape::Kind::kMesh;
      shape.dimensions = {mesh->scale.x, mesh->scale.y, mesh->scale.z};
      const std::optional<std::filesystem::path> path = find_mesh(mesh->filename, urdf_);
      if (!path) return warn_left_out(link, "mesh '" + mesh->filename + "' is not found");
      shape.mesh = *path;
    }
    const bool good = shape.dimensions.allFinite() && shape.dimensions.minCoeff() >= 0.0 && shape.dimensions.x() > 0.0;
    return good || shape.kind == LinkShape::Kind::kMesh || warn_left_out(link, "a shape has an impossible size");
  }

  bool warn_left_out(const std::string& link, const std::string& what) {
    const std::string warning = urdf_.string() + ": link '" + link + "': " + what + " and left out";
    if (std::find(model_.warnings.begin(), model_.warnings.end(), warning) == model_.warnings.end()) {
      model_.warnings.push_back(warning);
    }
    return false;
  }

  const urdf::ModelInterface& source_;
  const std::filesystem::path& urdf_;
  Model model_;
};

}  // namespace

Model read_urdf_tree(const std::string& text, const std::filesystem::path& urdf) {
  const urdf::ModelInterfaceSharedPtr source = parse(text, urdf.string());
  return TreeReader(*source, urdf).run();
}

}  // namespace amiss::robot
