// SDF files -> World or Body.
// In: a .sdf/.world file of any version that libsdformat reads, the models, meshes and textures that it names. Out:
// bodies in the world frame (z up, metres) with everything resolved: includes, nested models, relative poses. A model
// whose links hang together by joints is taken as one rigid body. What cannot be used (missing models, meshes or
// textures, actors, plugins, sensors) is left out, what is wrong but can be mended (duplicate names, invalid inertia)
// is mended; both with a warning. Errors: InputError with file, line where known, and what is wrong.
#pragma once

#include <filesystem>
#include <vector>

#include "core/params.hpp"
#include "world/world.hpp"

namespace amiss::world {

struct LoadOptions {
  /// Searched for model:// and package:// after the file's own folder, its ancestors and their `models` folders, and
  /// before those of the environment (SDF_PATH, GAZEBO_MODEL_PATH, GZ_SIM_RESOURCE_PATH).
  std::vector<std::filesystem::path> model_paths;
  /// Larger textures are scaled down to this longest edge [px].
  int max_texture_px = 512;
};
void describe(ParamTable& table, LoadOptions& options);

/// The world of an SDF file.
[[nodiscard]] World load_world(const std::filesystem::path& sdf, const LoadOptions& options = {});

/// The single model of an SDF file (or of a folder with a model.sdf), its pose set to identity. Warnings are added to
/// `warnings` of the result.
struct LoadedModel {
  Body body;
  std::vector<std::string> warnings;
};
[[nodiscard]] LoadedModel load_model_file(const std::filesystem::path& sdf, const LoadOptions& options = {});

/// The same without the warnings.
[[nodiscard]] Body load_model(const std::filesystem::path& sdf, const LoadOptions& options = {});

}  // namespace amiss::world
