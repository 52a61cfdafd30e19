// One mesh file through assimp; textures from a cache that several files share.
#pragma once

#include <filesystem>
#include <vector>

#include "world/internal/texture_cache.hpp"
#include "world/mesh_file.hpp"

namespace amiss::world {

[[nodiscard]] MeshFile read_mesh_file(const std::filesystem::path& file, TextureCache& textures);

}  // namespace amiss::world
