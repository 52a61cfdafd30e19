// Where the files are that an SDF names: model://, package://, file://, absolute paths, and paths relative to the file
// that names them. In: uri -> path that exists, or nothing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace amiss::world {

class ResourceFinder {
 public:
  /// Looks beside `sdf` and in its ancestors (and their `models` folders), then in `extra`, then in the environment's
  /// SDF_PATH, GAZEBO_MODEL_PATH and GZ_SIM_RESOURCE_PATH.
  ResourceFinder(const std::filesystem::path& sdf, const std::vector<std::filesystem::path>& extra);

  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& uri,
                                                          const std::filesystem::path& folder_of_user) const;
  /// The same for a model: a folder stands for the .sdf that its model.config names, or its model.sdf.
  [[nodiscard]] std::optional<std::filesystem::path> find_model(const std::string& uri,
                                                                const std::filesystem::path& folder_of_user) const;

 private:
  std::vector<std::filesystem::path> roots_;
};

/// The .sdf of a model's folder; nothing where there is none.
[[nodiscard]] std::optional<std::filesystem::path> sdf_of_folder(const std::filesystem::path& folder);

}  // namespace amiss::world
