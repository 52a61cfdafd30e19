// libFuzzer target: any bytes as a recording, and as each of the messages that a replay reads, end with values or with
// an InputError.
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "core/result.hpp"
#include "recording/recording.hpp"

namespace {

template <class Read>
void attempt(Read read) {
  try {
    read();
  } catch (const amiss::InputError&) {  // what bad input should end with
  }
}

/// A file of this process, written anew each time.
std::filesystem::path as_file(std::string_view bytes) {
  const auto file = std::filesystem::temp_directory_path() / ("amiss_fuzz_" + std::to_string(::getpid()) + ".mcap");
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amiss::recording;
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  const auto file = as_file(bytes);
  attempt([&] {
    McapReader reader(file);
    while (reader.next()) continue;
  });
  attempt([&] {
    Recording recording(file);
    while (recording.next()) continue;
  });
  std::filesystem::remove(file);
  amiss::RgbdFrame frame;
  amiss::LaserScan scan;
  attempt([&] { (void)parse_setup(bytes); });
  attempt([&] { (void)parse_observation(bytes); });
  attempt([&] { (void)parse_decision(bytes); });
  attempt([&] { parse_ranges(bytes, scan); });
  attempt([&] { parse_camera_info(bytes, frame.intrinsics); });
  attempt([&] { parse_depth(bytes, frame); });
  attempt([&] { parse_colour(bytes, frame); });
  return 0;
}
