// Where the program's own files are: worlds, the robot, objects, the planning domain.
// $AMISS_SHARE, else ../share/amiss beside an installed program, else the source tree that it was built from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amiss::app {

struct Resources {
  std::filesystem::path worlds, robot, objects, pddl, scenarios, init;
};
[[nodiscard]] Resources find_resources();

/// The file of a world given by name or path; ArgumentError with the nearest name, InputError for a missing file.
[[nodiscard]] std::filesystem::path find_world(const Resources& resources, const std::string& name_or_file);
[[nodiscard]] std::vector<std::string> world_names(const Resources& resources);

/// The file of this program, for its children.
[[nodiscard]] std::string own_program();
/// For children that must be the same program even when that file was replaced by a newer one since.
inline constexpr const char* kRunningProgram = "/proc/self/exe";
/// A hash of the executable that is running: 20 hex digits. It tells two builds apart, not two sets of shared
/// libraries.
[[nodiscard]] std::string program_hash();

/// Of the user: $XDG_CACHE_HOME/amiss, ~/.cache/amiss, or a folder in the temporary one.
[[nodiscard]] std::filesystem::path cache_folder();

}  // namespace amiss::app
