#include "world/loader.hpp"

#include <algorithm>

#include "core/result.hpp"
#include "world/internal/body_maker.hpp"
#include "world/internal/resource_finder.hpp"
#include "world/internal/sdf_reader.hpp"

namespace amiss::world {
namespace {

namespace fs = std::filesystem;

/// A folder stands for the model in it.
fs::path file_of(const fs::path& sdf) {
  std::error_code error;
  if (!fs::is_directory(sdf, error)) return sdf;
  const std::optional<fs::path> inside = sdf_of_folder(sdf);
  if (!inside) throw InputError(sdf.string() + ": no model.sdf in this folder");
  return *inside;
}

}  // namespace

void describe(ParamTable& table, LoadOptions& options) {
  table.integer("world.max_texture", options.max_texture_px, 16, 8192,
                "longest edge of a texture [px]; larger ones are scaled down");
}

World load_world(const fs::path& sdf, const LoadOptions& options) {
  const ResourceFinder finder(sdf, options.model_paths);
  SdfReader reader(finder, options.max_texture_px);
  FileTree tree = reader.read(sdf);
  if (!tree.is_world) throw InputError(sdf.string() + ": no <world> element in it; a world file is needed");
  World world;
  world.name = tree.world_name;
  world.file = sdf;
  world.robot_start = tree.robot_start;
  world.lights = std::move(tree.lights);
  if (world.lights.empty()) world.lights.emplace_back();  // lamps of other kinds are not drawn; it must not be dark
  if (tree.ambient) world.ambient = *tree.ambient;
  if (tree.background) world.background = *tree.background;
  world.warnings = reader.warnings();
  for (const ModelTree& model : tree.models) {
    std::vector<Body> bodies = make_bodies(model, world.warnings);
    std::move(bodies.begin(), bodies.end(), std::back_inserter(world.bodies));
  }
  make_names_unique(world.bodies, world.warnings);
  return world;
}

LoadedModel load_model_file(const fs::path& sdf, const LoadOptions& options) {
  const fs::path file = file_of(sdf);
  const ResourceFinder finder(file, options.model_paths);
  SdfReader reader(finder, options.max_texture_px);
  const FileTree tree = reader.read(file);
  if (tree.is_world || tree.models.empty()) {
    throw InputError(file.string() + ": a file with one <model> is needed, not a world or a light");
  }
  LoadedModel loaded;
  loaded.warnings = reader.warnings();
  ModelTree model = tree.models.front();
  model.T_parent_model.setIdentity();
  std::vector<Body> bodies = make_bodies(model, loaded.warnings);
  if (bodies.size() != 1) {
    throw InputError(file.string() + ": model '" + model.name + "' has " + std::to_string(bodies.size()) +
                     " bodies that move apart; exactly one is allowed");
  }
  loaded.body = std::move(bodies.front());
  return loaded;
}

Body load_model(const fs::path& sdf, const LoadOptions& options) { return load_model_file(sdf, options).body; }

}  // namespace amiss::world
