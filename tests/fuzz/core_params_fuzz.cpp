// libFuzzer target: any bytes as a parameter file end with values within their ranges or an error, never with a crash.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "core/params.hpp"
#include "core/result.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("amiss_fuzz_" + std::to_string(getpid()) + ".yaml");
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  double length = 0.05, angle = 1.0;
  int count = 3;
  amiss::ParamTable table;
  table.number("map.length", length, "m", 0.01, 0.5, "a length");
  table.number("map.angle", angle, "deg", 10.0, 120.0, "an angle");
  table.integer("view.count", count, 1, 10, "a count");
  try {
    table.load_file(file);
  } catch (const amiss::ArgumentError&) {  // what bad input should end with
  } catch (const amiss::InputError&) {
  }
  if (!(length >= 0.01 && length <= 0.5) || !(angle > 0.17 && angle < 2.1) || count < 1 || count > 10) __builtin_trap();
  std::filesystem::remove(file);
  return 0;
}
