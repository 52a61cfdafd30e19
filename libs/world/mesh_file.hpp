// Mesh files (.obj, .dae, .stl, .ply, ...) -> triangles with materials.
// Out: parts in the file's own axes, in metres: the unit of a .dae is applied, its up_axis is not (models made for
// Gazebo stand upright as they are). Normals are computed where they are missing; a part is one node and material.
// Errors: InputError naming the file. What is missing beside it (textures, materials) becomes a warning.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace amiss::world {

struct MeshPart {
  std::string name;  // of the submesh
  std::shared_ptr<const Mesh> mesh;
  Material material;
};

struct MeshFile {
  std::vector<MeshPart> parts;
  std::vector<std::string> warnings;
};

[[nodiscard]] MeshFile load_mesh(const std::filesystem::path& file, int max_texture_px = 512);

/// An image scaled down to a longest edge of at most max_texture_px; InputError when it cannot be read.
[[nodiscard]] std::shared_ptr<const Texture> load_texture(const std::filesystem::path& file, int max_texture_px = 512);

}  // namespace amiss::world
