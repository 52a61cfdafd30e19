// The objects that may lie about: one folder each with a model.sdf of one movable link.
// In: folders that hold such folders. Out: entries sorted by name. Errors: InputError when a folder is missing or
// holds none, ArgumentError with the nearest known name when an object is not there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "world/loader.hpp"

namespace amiss::world {

struct CatalogueEntry {
  std::string name;   // of the folder
  std::string label;  // what people call it: the name in its model.config, or the name with spaces
  Body body;          // named after the folder, not static, at the origin
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // edges of its bounding box
};

struct Catalogue {
  std::vector<CatalogueEntry> entries;  // sorted by name
  std::vector<std::string> warnings;

  [[nodiscard]] const CatalogueEntry* find(std::string_view name) const;  // nullptr where there is none
  [[nodiscard]] const CatalogueEntry& at(std::string_view name) const;
};

/// All objects of the folders; of two with one name the one of the later folder counts.
[[nodiscard]] Catalogue load_catalogue(const std::vector<std::filesystem::path>& folders,
                                       const LoadOptions& options = {});

}  // namespace amiss::world
