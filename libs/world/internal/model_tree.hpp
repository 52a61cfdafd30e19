// What one SDF file holds, in the frame of its model or world, before bodies are made of it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "world/world.hpp"

namespace amiss::world {

struct LinkNode {
  std::string name;  // "nested::link" where the link belongs to a nested model
  Eigen::Isometry3d T_model_link = Eigen::Isometry3d::Identity();
  double mass_kg = 1.0;
  std::optional<double> friction;
  std::vector<Shape> visuals, collisions;
};

/// Names of the links that a joint ties together; "world" is the fixed world.
using JointTie = std::pair<std::string, std::string>;

struct ModelTree {
  std::string name;
  bool is_static = false;
  std::string pose_text;  // of the model element, used by an include without pose
  Eigen::Isometry3d T_parent_model = Eigen::Isometry3d::Identity();  // resolved
  std::vector<LinkNode> links;
  std::vector<JointTie> joints;
};

/// A file's models by their place; an included file has one model, or lights only.
struct FileTree {
  std::string world_name;
  bool is_world = false;
  std::vector<ModelTree> models;
  std::vector<Light> lights;
  std::optional<Eigen::Vector3f> ambient, background;
  std::optional<Pose2<amiss::World, Base>> robot_start;
};

/// An include that stands as a placeholder model in the text given to the parser.
struct IncludedModel {
  std::shared_ptr<const FileTree> file;
  std::optional<bool> is_static;  // set where the include says so
};

}  // namespace amiss::world
