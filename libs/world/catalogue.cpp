#include "world/catalogue.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <map>

#include "core/result.hpp"
#include "world/bounds.hpp"

namespace amiss::world {
namespace {

namespace fs = std::filesystem;

std::string label_of(const fs::path& folder) {
  tinyxml2::XMLDocument config;
  if (config.LoadFile((folder / "model.config").c_str()) == tinyxml2::XML_SUCCESS) {
    const tinyxml2::XMLElement* model = config.FirstChildElement("model");
    const tinyxml2::XMLElement* name = model != nullptr ? model->FirstChildElement("name") : nullptr;
    if (name != nullptr && name->GetText() != nullptr) return name->GetText();
  }
  std::string label = folder.filename().string();
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

CatalogueEntry load_entry(const fs::path& folder, const LoadOptions& options, std::vector<std::string>& warnings) {
  LoadedModel loaded = load_model_file(folder, options);
  warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
  CatalogueEntry entry{folder.filename().string(), label_of(folder), std::move(loaded.body)};
  entry.body.name = entry.name;
  entry.body.is_static = false;
  if (entry.body.collisions.empty()) {
    throw InputError(folder.string() + ": the object has no collision shape; at least one is needed");
  }
  const Eigen::AlignedBox3d box = bounds_in_world(entry.body);
  entry.size_m = box.sizes();
  return entry;
}

std::vector<fs::path> model_folders(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw InputError(folder.string() + ": no such folder of objects");
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_directory(error) && fs::exists(entry.path() / "model.sdf", error)) found.push_back(entry.path());
  }
  if (found.empty()) throw InputError(folder.string() + ": no folder with a model.sdf in it");
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

const CatalogueEntry* Catalogue::find(std::string_view name) const {
  const auto found = std::lower_bound(entries.begin(), entries.end(), name,
                                      [](const CatalogueEntry& entry, std::string_view n) { return entry.name < n; });
  return found != entries.end() && found->name == name ? &*found : nullptr;
}

const CatalogueEntry& Catalogue::at(std::string_view name) const {
  if (const CatalogueEntry* entry = find(name)) return *entry;
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : entries) names.push_back(entry.name);
  const std::string nearest = nearest_word(name, names);
  throw ArgumentError(
      "no object '" + std::string(name) + "' in the catalogue" +
      (nearest.empty() ? "; see `amiss objects` for what there is" : "; did you mean '" + nearest + "'?"));
}

Catalogue load_catalogue(const std::vector<fs::path>& folders, const LoadOptions& options) {
  std::map<std::string, fs::path> by_name;
  for (const fs::path& folder : folders) {
    for (const fs::path& model : model_folders(folder)) by_name[model.filename().string()] = model;
  }
  Catalogue catalogue;
  for (const auto& [name, folder] : by_name) {
    catalogue.entries.push_back(load_entry(folder, options, catalogue.warnings));
  }
  return catalogue;
}

}  // namespace amiss::world
