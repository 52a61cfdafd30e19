// The document of libsdformat -> tree with resolved poses.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "world/internal/model_tree.hpp"
#include "world/internal/sdf_text.hpp"
#include "world/internal/shape_reader.hpp"

namespace amiss::world {

/// InputError (file:line where known) when libsdformat finds nothing usable in the text; what it merely complains
/// about is added to `warnings`.
[[nodiscard]] FileTree build_tree(const SdfText& text, const std::filesystem::path& file, ShapeReader& shapes,
                                  std::vector<std::string>& warnings);

}  // namespace amiss::world
