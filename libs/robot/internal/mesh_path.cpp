#include "robot/internal/mesh_path.hpp"

namespace amiss::robot {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxAncestors = 8;

std::optional<fs::path> if_there(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) ? std::optional(path) : std::nullopt;
}

}  // namespace

std::optional<fs::path> find_mesh(const std::string& uri, const fs::path& urdf) {
  if (uri.empty()) return std::nullopt;
  std::error_code error;
  fs::path folder = fs::weakly_canonical(urdf, error).parent_path();
  const std::size_t scheme_end = uri.find("://");
  if (scheme_end == std::string::npos) return if_there(folder / uri);
  const fs::path rest = uri.substr(scheme_end + 3);
  if (uri.compare(0, scheme_end, "file") == 0) return if_there(folder / rest);
  if (rest.empty()) return std::nullopt;
  const fs::path below_package = rest.lexically_relative(*rest.begin());
  for (int i = 0; i < kMaxAncestors && folder.has_relative_path(); ++i, folder = folder.parent_path()) {
    if (const auto found = if_there(folder / rest)) return found;
    if (folder.filename() == *rest.begin()) {
      if (const auto found = if_there(folder / below_package)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace amiss::robot
