// An SDF file made digestible: XML checked, what nobody simulates taken out, names made unique, inertia repaired,
// joints turned into ties, includes replaced by placeholder models that carry the links' frames. In: file -> text for
// libsdformat and what was taken out. Errors: InputError with file and line.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "world/internal/model_tree.hpp"

namespace amiss::world {

struct SdfText {
  std::string text;
  bool is_world = false;
  std::map<std::string, IncludedModel> includes;        // by scoped name, "model::nested"
  std::map<std::string, std::vector<JointTie>> joints;  // by the scoped name of their model
  std::map<std::string, std::string> pose_texts;        // by the scoped name of the model
  std::vector<Light> lights;                            // of included files
  std::map<std::string, int> lines;                     // of named elements
  std::vector<std::string> warnings;
};

/// Finds and reads what an include's uri names; null (after a warning of its own) where that fails.
using IncludeReader = std::function<std::shared_ptr<const FileTree>(const std::string& uri, const std::string& where)>;

[[nodiscard]] SdfText prepare_sdf(const std::filesystem::path& file, const IncludeReader& read_include);

}  // namespace amiss::world
