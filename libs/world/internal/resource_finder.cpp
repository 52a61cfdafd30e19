#include "world/internal/resource_finder.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace amiss::world {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxAncestors = 8;
constexpr double kNewestVersion = 1.9;  // of SDF, as the parser knows it

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

void add_with_models(std::vector<fs::path>& roots, const fs::path& folder) {
  roots.push_back(folder);
  if (is_there(folder / "models")) roots.push_back(folder / "models");
}

void add_from_environment(std::vector<fs::path>& roots, const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr) return;
  std::istringstream parts(value);
  for (std::string part; std::getline(parts, part, ':');) {
    if (!part.empty()) roots.emplace_back(part);
  }
}

/// Does `rest` stay below its root? A URI must not climb out of the folder that it names.
bool climbs(const fs::path& rest) {
  return std::any_of(rest.begin(), rest.end(), [](const fs::path& part) { return part == ".."; });
}

}  // namespace

ResourceFinder::ResourceFinder(const fs::path& sdf, const std::vector<fs::path>& extra) {
  std::error_code error;
  fs::path folder = fs::weakly_canonical(fs::absolute(sdf, error), error).parent_path();
  for (int i = 0; i < kMaxAncestors && folder.has_relative_path(); ++i) {
    add_with_models(roots_, folder);
    folder = folder.parent_path();
  }
  for (const fs::path& path : extra) add_with_models(roots_, fs::absolute(path, error));
  for (const char* variable : {"SDF_PATH", "GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH"}) {
    add_from_environment(roots_, variable);
  }
}

std::optional<fs::path> ResourceFinder::find(const std::string& uri, const fs::path& folder_of_user) const {
  const std::size_t scheme_end = uri.find("://");
  if (uri.empty() || uri.find('\0') != std::string::npos) return std::nullopt;
  if (scheme_end == std::string::npos) {
    const fs::path path = folder_of_user / uri;  // an absolute uri replaces the folder
    return is_there(path) ? std::optional(path) : std::nullopt;
  }
  const std::string scheme = uri.substr(0, scheme_end);
  const std::string rest = uri.substr(scheme_end + 3);
  if (scheme == "file") {
    for (const fs::path& path : {fs::path(rest), folder_of_user / fs::path(rest).relative_path()}) {
      if (is_there(path)) return path;
    }
  }
  const fs::path relative = fs::path(rest).relative_path();
  if ((scheme != "model" && scheme != "package" && scheme != "file") || relative.empty() || climbs(relative)) {
    return std::nullopt;
  }
  const fs::path below_first = relative.lexically_relative(*relative.begin());
  for (const fs::path& root : roots_) {
    if (is_there(root / relative)) return root / relative;
    if (root.filename() == *relative.begin() && is_there(root / below_first)) return root / below_first;
  }
  return std::nullopt;
}

std::optional<fs::path> ResourceFinder::find_model(const std::string& uri, const fs::path& folder_of_user) const {
  const std::optional<fs::path> found = find(uri, folder_of_user);
  std::error_code error;
  return found && fs::is_directory(*found, error) ? sdf_of_folder(*found) : found;
}

std::optional<fs::path> sdf_of_folder(const fs::path& folder) {
  fs::path best = folder / "model.sdf";
  double best_version = 0.0;
  tinyxml2::XMLDocument config;
  const bool readable = config.LoadFile((folder / "model.config").c_str()) == tinyxml2::XML_SUCCESS;
  const tinyxml2::XMLElement* model = readable ? config.FirstChildElement("model") : nullptr;
  const tinyxml2::XMLElement* sdf = model != nullptr ? model->FirstChildElement("sdf") : nullptr;
  for (; sdf != nullptr; sdf = sdf->NextSiblingElement("sdf")) {
    const double version = sdf->DoubleAttribute("version", 1.0);
    const char* name = sdf->GetText();
    if (name != nullptr && version > best_version && version <= kNewestVersion && is_there(folder / name)) {
      best = folder / name;
      best_version = version;
    }
  }
  return is_there(best) ? std::optional(best) : std::nullopt;
}

}  // namespace amiss::world
