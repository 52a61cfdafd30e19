#include "world/internal/texture_cache.hpp"

#include "core/result.hpp"
#include "world/mesh_file.hpp"

namespace amiss::world {

std::shared_ptr<const Texture> TextureCache::get(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path key = std::filesystem::weakly_canonical(file, error);
  const auto known = textures_.find(key);
  if (known != textures_.end()) return known->second;
  return textures_.emplace(key, load_texture(file, max_texture_px_)).first->second;
}

}  // namespace amiss::world
