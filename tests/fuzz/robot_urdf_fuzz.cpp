// Any bytes as a URDF file: a model with finite poses or an InputError, never a crash.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "core/result.hpp"
#include "robot/model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("amiss_fuzz_" + std::to_string(getpid()) + ".urdf");
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const amiss::robot::Model model = amiss::robot::load_model(file);
    for (const Eigen::Isometry3d& T : model.link_poses({{model.pan_joint, 0.3}, {model.tilt_joint, -0.4}})) {
      if (!T.matrix().allFinite()) __builtin_trap();
    }
  } catch (const amiss::InputError&) {
  }
  std::filesystem::remove(file);
  return 0;
}
