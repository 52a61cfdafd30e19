// The text of a URDF file, checked before a parser sees it.
#pragma once

#include <filesystem>
#include <string>

namespace amiss::robot {

/// InputError for files that are empty, too large, not XML at all, xacro, or nested deeper than any robot.
[[nodiscard]] std::string load_urdf_text(const std::filesystem::path& urdf);

}  // namespace amiss::robot
