// Any bytes as an SDF file: a world or an InputError, never a crash.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "core/result.hpp"
#include "world/loader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("amiss_fuzz_" + std::to_string(getpid()) + ".sdf");
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const amiss::world::World world = amiss::world::load_world(file);
    for (const amiss::world::Body& body : world.bodies) {
      if (!body.pose.T.matrix().allFinite() || !(body.mass_kg >= 0.0)) __builtin_trap();
    }
  } catch (const amiss::InputError&) {
  }
  std::filesystem::remove(file);
  return 0;
}
