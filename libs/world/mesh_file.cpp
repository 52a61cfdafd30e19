#include "world/mesh_file.hpp"

#include "world/internal/scene_reader.hpp"

namespace amiss::world {

MeshFile load_mesh(const std::filesystem::path& file, int max_texture_px) {
  TextureCache textures(max_texture_px);
  return read_mesh_file(file, textures);
}

}  // namespace amiss::world
