#include "resources.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/files.hpp"
#include "core/params.hpp"
#include "core/result.hpp"

namespace amiss::app {

namespace fs = std::filesystem;

namespace {

Resources in_folder(const fs::path& share, const fs::path& top) {
  return {top / "sim_worlds", top / "robot_model" / "hsr.urdf", share / "objects", share / "pddl", share / "scenarios",
          share / "init"};
}

}  // namespace

Resources find_resources() {
  if (const char* chosen = std::getenv("AMISS_SHARE"); chosen != nullptr && *chosen != '\0') {
    return in_folder(chosen, chosen);
  }
  std::error_code error;
  const fs::path installed = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path() / "share" / "amiss";
  if (!error && fs::exists(installed / "pddl")) return in_folder(installed, installed);
  const fs::path source = AMISS_SOURCE_DIR;
  if (!fs::exists(source / "share" / "pddl")) {
    throw InputError("the share folder of amiss was not found; set AMISS_SHARE to where it is");
  }
  return in_folder(source / "share", source);
}

std::vector<std::string> world_names(const Resources& resources) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(resources.worlds)) {
    if (entry.path().extension() == ".sdf") names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_world(const Resources& resources, const std::string& name_or_file) {
  const fs::path own = resources.worlds / (name_or_file + ".sdf");
  if (fs::path(name_or_file).filename() == name_or_file && fs::exists(own)) return own;
  if (fs::exists(name_or_file)) return fs::absolute(name_or_file);
  if (name_or_file.find('/') != std::string::npos || fs::path(name_or_file).has_extension()) {
    throw InputError(name_or_file + ": there is no such file");
  }
  const std::string near = nearest_word(name_or_file, world_names(resources));
  throw ArgumentError("--world " + name_or_file + ": there is no such world" +
                      (near.empty() ? "; `amiss worlds` lists them" : "; did you mean '" + near + "'?"));
}

std::string own_program() { return fs::read_symlink(kRunningProgram).string(); }

std::string program_hash() {
  constexpr std::size_t kDigits = 20;
  return sha256(load_bytes(kRunningProgram)).substr(0, kDigits);
}

fs::path cache_folder() {
  const auto folder_of = [](const char* variable) -> fs::path {
    const char* value = std::getenv(variable);
    return value == nullptr ? fs::path() : fs::path(value);
  };
  if (const fs::path cache = folder_of("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "amiss";
  if (const fs::path home = folder_of("HOME"); home.is_absolute()) return home / ".cache" / "amiss";
  return fs::temp_directory_path() / "amiss-cache";
}

}  // namespace amiss::app
