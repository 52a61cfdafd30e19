#include "kinds.hpp"

#include <algorithm>

namespace amiss::app {

namespace fs = std::filesystem;

namespace {

bool is_model(const fs::path& folder) { return fs::exists(folder / "model.sdf"); }

}  // namespace

std::vector<std::string> models_in(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_model(entry.path())) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::map<std::string, world::Body> load_kinds(const Resources& resources, const std::set<std::string>& kinds,
                                              const world::LoadOptions& options) {
  std::map<std::string, world::Body> bodies;
  for (const std::string& kind : kinds) {
    if (kind.empty() || fs::path(kind).filename() != kind) continue;
    for (const fs::path& folder : {resources.objects, resources.worlds / "models", resources.scenarios / "models"}) {
      if (!is_model(folder / kind)) continue;
      world::Body body = world::load_model(folder / kind, options);
      body.name = kind;
      if (folder == resources.objects) body.is_static = false;
      bodies.emplace(kind, std::move(body));
      break;
    }
  }
  return bodies;
}

}  // namespace amiss::app
