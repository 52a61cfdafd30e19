#include "world/fingerprint.hpp"

#include <map>
#include <span>
#include <type_traits>

#include "core/files.hpp"

namespace amiss::world {

namespace {

/// Gathers the bytes of values; a mesh or texture that several shapes share is hashed once.
class Bytes {
 public:
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) { text_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void add(const std::string& text) {
    add(text.size());
    text_ += text;
  }
  template <class Derived>
  void add(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) add(matrix(i));
  }
  void add(const Eigen::Isometry3d& pose) { add(pose.matrix()); }
  template <class T>
  void add_shared(const std::shared_ptr<const T>& value) {
    if (!value) return add(0);
    auto [known, is_new] = hashes_.try_emplace(value.get());
    if (is_new) known->second = hash_of(*value);
    add(known->second);
  }
  [[nodiscard]] std::string hash() const { return sha256(text_); }

 private:
  template <class T>
  static std::string raw(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
  }
  static std::string hash_of(const Mesh& mesh) {
    return sha256(raw(mesh.vertices) + raw(mesh.normals) + raw(mesh.uvs) + raw(mesh.colours) + raw(mesh.indices));
  }
  static std::string hash_of(const Texture& texture) {
    return sha256(std::to_string(texture.width) + "x" + std::to_string(texture.height) + raw(texture.pixels));
  }

  std::string text_;
  std::map<const void*, std::string> hashes_;
};

void add_geometry(Bytes& bytes, const Geometry& geometry) {
  bytes.add(geometry.index());
  std::visit(
      [&](const auto& g) {
        using G = std::decay_t<decltype(g)>;
        if constexpr (std::is_same_v<G, Box>) bytes.add(g.size);
        if constexpr (std::is_same_v<G, Cylinder>) bytes.add(Eigen::Vector2d(g.radius, g.length));
        if constexpr (std::is_same_v<G, Sphere>) bytes.add(g.radius);
        if constexpr (std::is_same_v<G, Plane>) bytes.add(g.normal), bytes.add(g.size);
        if constexpr (std::is_same_v<G, MeshInstance>) bytes.add_shared(g.mesh), bytes.add(g.scale);
      },
      geometry);
}

void add_shapes(Bytes& bytes, const std::vector<Shape>& shapes) {
  bytes.add(shapes.size());
  for (const Shape& shape : shapes) {
    add_geometry(bytes, shape.geometry);
    bytes.add(shape.T_body_shape);
    bytes.add(shape.material.diffuse);
    bytes.add(shape.material.alpha);
    bytes.add(shape.material.specular);
    bytes.add_shared(shape.material.texture);
  }
}

}  // namespace

std::string fingerprint(const World& world) {
  Bytes bytes;
  for (const Body& body : world.bodies) {
    bytes.add(body.name);
    bytes.add(body.pose.T);
    bytes.add(body.is_static);
    bytes.add(body.mass_kg);
    bytes.add(body.friction);
    add_shapes(bytes, body.visuals);
    add_shapes(bytes, body.collisions);
  }
  for (const Light& light : world.lights) {
    bytes.add(light.direction);
    bytes.add(light.colour);
  }
  bytes.add(world.ambient);
  bytes.add(world.background);
  if (world.robot_start) bytes.add(world.robot_start->lift().T);
  return bytes.hash();
}

}  // namespace amiss::world
