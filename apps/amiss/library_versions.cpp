#include "library_versions.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <vector>

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

/// The shared libraries of this process by the names that their files have: libmrpt-slam.so.2.5.8.
std::vector<std::string> loaded_libraries() {
  std::vector<std::string> names;
  const auto note = [](dl_phdr_info* info, std::size_t, void* list) {
    std::error_code error;
    const fs::path file = fs::canonical(info->dlpi_name, error);
    if (!error) static_cast<std::vector<std::string>*>(list)->push_back(file.filename().string());
    return 0;
  };
  ::dl_iterate_phdr(note, &names);
  return names;
}

}  // namespace

std::string library_versions() {
  struct Wanted {
    const char *name, *prefix;
  };
  constexpr std::array wanted{Wanted{"MRPT", "libmrpt-slam.so."}, Wanted{"OctoMap", "liboctomap.so."},
                              Wanted{"PCL", "libpcl_common.so."}, Wanted{"Bullet", "libBulletDynamics-float64.so."},
                              Wanted{"OMPL", "libompl.so."},      Wanted{"OpenCV", "libopencv_core.so."},
                              Wanted{"sdformat", "libsdformat"}};
  std::string text = fmt::format("Eigen {}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  for (const std::string& file : loaded_libraries()) {
    for (const Wanted& w : wanted) {
      if (file.starts_with(w.prefix)) text += fmt::format(", {} {}", w.name, file.substr(file.find(".so.") + 4));
    }
  }
  using Version = const char* (*)();
  if (const auto sqlite = reinterpret_cast<Version>(::dlsym(RTLD_DEFAULT, "sqlite3_libversion")); sqlite != nullptr) {
    text += std::string(", SQLite ") + sqlite();
  }
  return text;
}

}  // namespace amiss::app
