// A world as the simulator needs it: bodies with shapes, materials and masses, in the world frame (z up, SI).
// SDF file -> World with warnings about what was left out; InputError when the file cannot be used at all.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/frames.hpp"
#include "core/sensors.hpp"

namespace amiss::world {

struct Texture {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  // row 0 on top
};

struct Material {
  Eigen::Vector3f diffuse = Eigen::Vector3f(0.7F, 0.7F, 0.7F);  // linear factor, multiplied with the texture
  float alpha = 1.0F;     // below 0.99 the depth camera may see through: drawn in colour only
  float specular = 0.1F;  // 0 matt .. 1 shiny; shiny and black surfaces drop out of the depth image
  std::shared_ptr<const Texture> texture;
};

/// Triangles with one material; normals and (if textured) uvs, colours (if any) are as long as the vertices.
/// Texture coordinate (0, 0) is the lower left corner of the picture, (1, 1) the upper right one; it repeats outside.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;
  std::vector<Rgb> colours;
  std::vector<std::uint32_t> indices;  // three a triangle, counter-clockwise from outside
};

struct Box {
  Eigen::Vector3d size;
};
struct Cylinder {
  double radius;
  double length;
};  // along z, origin in the middle
struct Sphere {
  double radius;
};
struct Plane {
  Eigen::Vector3d normal;
  Eigen::Vector2d size;
};  // finite for drawing, endless for physics
struct MeshInstance {
  std::shared_ptr<const Mesh> mesh;
  Eigen::Vector3d scale;
};
using Geometry = std::variant<Box, Cylinder, Sphere, Plane, MeshInstance>;

struct Shape {
  Geometry geometry;
  Eigen::Isometry3d T_body_shape = Eigen::Isometry3d::Identity();
  Material material;  // of visuals
};

/// One rigid body (an SDF link; a static model is one body).
struct Body {
  std::string name;  // unique: the model's name, "::link" added where a model has several bodies
  Transform<amiss::World, Object> pose;
  bool is_static = true;
  double mass_kg = 1.0;
  double friction = 0.8;
  std::vector<Shape> visuals;
  std::vector<Shape> collisions;  // meshes of moving bodies are taken by their convex hull
};

struct Light {
  Eigen::Vector3f direction = Eigen::Vector3f(-0.4F, 0.3F, -0.85F);  // of the rays
  Eigen::Vector3f colour = Eigen::Vector3f(0.6F, 0.6F, 0.6F);
};

class World {  // NOLINT: the frame tag of the same name lives in namespace amiss
 public:
  std::string name;
  std::filesystem::path file;
  std::vector<Body> bodies;
  std::vector<Light> lights;
  Eigen::Vector3f ambient = Eigen::Vector3f(0.4F, 0.4F, 0.4F);
  Eigen::Vector3f background = Eigen::Vector3f(0.75F, 0.8F, 0.85F);
  std::optional<Pose2<amiss::World, Base>> robot_start;  // <frame name="robot_start">
  std::vector<std::string> warnings;                     // each names file and element
};

}  // namespace amiss::world
