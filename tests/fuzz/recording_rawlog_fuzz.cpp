// libFuzzer target: any bytes as a rawlog, packed or not, end with entries or with an InputError.
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "core/result.hpp"
#include "recording/rawlog_recording.hpp"

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
  const auto file = std::filesystem::temp_directory_path() / ("amiss_fuzz_" + std::to_string(::getpid()) + ".rawlog");
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amiss::recording;
  const auto file = as_file({reinterpret_cast<const char*>(data), size});
  attempt([&] {
    RawlogReader reader(file);
    while (reader.next()) continue;
  });
  attempt([&] {
    RawlogRecording recording(file);
    while (const auto entry = recording.next()) {
      const auto* seen = std::get_if<amiss::robot::Observation>(&*entry);
      if (seen == nullptr || !seen->frame) continue;
      const amiss::RgbdFrame& frame = seen->frame->frame;
      const auto pixels = static_cast<std::size_t>(frame.intrinsics.width * frame.intrinsics.height);
      if (frame.depth_m.size() != pixels) __builtin_trap();
    }
  });
  std::filesystem::remove(file);
  return 0;
}
