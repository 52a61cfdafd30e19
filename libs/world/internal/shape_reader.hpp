// sdf::Visual and sdf::Collision -> shapes with meshes, materials and textures, each file loaded once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "world/internal/resource_finder.hpp"
#include "world/internal/texture_cache.hpp"
#include "world/mesh_file.hpp"
#include "world/world.hpp"

namespace sdf {
inline namespace v12 {
class Collision;
class Geometry;
class Material;
class Mesh;
class Visual;
}  // namespace v12
}  // namespace sdf

namespace amiss::world {

class ShapeReader {
 public:
  ShapeReader(const ResourceFinder& finder, int max_texture_px) : finder_(finder), textures_(max_texture_px) {}

  /// Shapes in the frame of the visual or collision; none (with a warning) where the geometry cannot be used. `file`
  /// is the SDF that names them.
  [[nodiscard]] std::vector<Shape> read(const sdf::Visual& visual, const std::filesystem::path& file);
  [[nodiscard]] std::vector<Shape> read(const sdf::Collision& collision, const std::filesystem::path& file);

  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  /// What is drawn is merged by material; what is touched stays apart, so that each part has a hull of its own.
  enum class Use { kDrawn, kTouched };
  struct LoadedMesh {
    std::vector<MeshPart> parts, merged;
  };

  std::vector<Shape> read_geometry(const sdf::Geometry& geometry, const std::filesystem::path& file, Use use);
  std::vector<Shape> read_mesh(const sdf::Mesh& mesh, const std::filesystem::path& file, Use use);
  const LoadedMesh* mesh_file(const std::string& uri, const std::filesystem::path& file);
  Material material_of(const sdf::Material& source, const std::filesystem::path& file, const Material& of_mesh);
  std::optional<Material> script_material(const sdf::Material& source, const std::filesystem::path& file);
  std::shared_ptr<const Texture> texture(const std::string& uri, const std::filesystem::path& file);
  void warn_once(const std::string& warning);

  const ResourceFinder& finder_;
  TextureCache textures_;
  std::map<std::filesystem::path, LoadedMesh> meshes_;  // without parts: could not be read
  std::map<std::string, std::optional<Material>> scripts_;
  std::set<std::string> said_;
  std::vector<std::string> warnings_;
};

}  // namespace amiss::world
