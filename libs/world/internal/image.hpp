// Bytes of a picture -> texture.
#pragma once

#include <memory>
#include <string>

#include "world/world.hpp"

namespace amiss::world {

/// Null where the bytes are no picture.
[[nodiscard]] std::shared_ptr<const Texture> decode_texture(const std::string& bytes, int max_texture_px);

}  // namespace amiss::world
