// The document of libsdformat -> tree with resolved poses.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "world/internal/model_tree.hpp"
#include "world/internal/sdf_text.hpp"
#include "world/internal/shape_reader.hpp"

namespace sdf {
inline namespace v12 {
class SDF;
}
}  // namespace sdf

namespace amiss::world {

/// The grammar of SDF, which takes libsdformat tens of milliseconds to set up: made once, used for every file.
[[nodiscard]] std::shared_ptr<sdf::SDF> make_sdf_grammar();

/// InputError (file:line where known) when libsdformat finds nothing usable in the text; what it merely complains
/// about is added to `warnings`.
[[nodiscard]] FileTree build_tree(const SdfText& text, const std::filesystem::path& file,
                                  const std::shared_ptr<sdf::SDF>& grammar, ShapeReader& shapes,
                                  std::vector<std::string>& warnings);

}  // namespace amiss::world
