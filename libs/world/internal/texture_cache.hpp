// Textures, each file decoded once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>

#include "world/world.hpp"

namespace amiss::world {

class TextureCache {
 public:
  explicit TextureCache(int max_texture_px) : max_texture_px_(max_texture_px) {}

  /// InputError, each time, when the file is no picture.
  [[nodiscard]] std::shared_ptr<const Texture> get(const std::filesystem::path& file);
  [[nodiscard]] int max_texture_px() const { return max_texture_px_; }

 private:
  int max_texture_px_;
  std::map<std::filesystem::path, std::shared_ptr<const Texture>> textures_;
};

}  // namespace amiss::world
