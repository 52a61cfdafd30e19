// Where a mesh is that a URDF names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace amiss::robot {

/// package://name/rest in the file's ancestors (or their child `name`), file://, absolute, or relative to the file;
/// nothing where it is not there.
[[nodiscard]] std::optional<std::filesystem::path> find_mesh(const std::string& uri, const std::filesystem::path& urdf);

}  // namespace amiss::robot
