// libFuzzer target: any bytes as a ROS 1 bag end with frames of the size that its camera has, or with an InputError; as
// a robot's bag with moments in the order of time, or with one.
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "core/result.hpp"
#include "dataset/recording.hpp"
#include "dataset/robot_bag.hpp"

namespace {

constexpr std::size_t kFrames = 4;  // at most so many are loaded

template <class Read>
void attempt(Read read) {
  try {
    read();
  } catch (const amiss::InputError&) {  // what bad input should end with
  }
}

/// A file of this process, written anew each time.
std::filesystem::path as_file(std::string_view bytes) {
  const auto file = std::filesystem::temp_directory_path() / ("amiss_fuzz_" + std::to_string(::getpid()) + ".bag");
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = as_file({reinterpret_cast<const char*>(data), size});
  attempt([&] {
    const auto recording = amiss::dataset::open_recording(file);
    for (std::size_t i = 0; i < std::min(recording->size(), kFrames); ++i) {
      const amiss::RgbdFrame frame = recording->load(i).frame;
      const auto pixels = static_cast<std::size_t>(frame.intrinsics.width * frame.intrinsics.height);
      if (frame.depth_m.size() != pixels || frame.colour.size() != pixels) __builtin_trap();
    }
  });
  attempt([&] {
    amiss::dataset::RobotBag bag(file);
    amiss::Stamp last{};
    while (const auto moment = bag.next()) {
      if (moment->odometry.stamp < last) __builtin_trap();
      last = moment->odometry.stamp;
    }
  });
  std::filesystem::remove(file);
  return 0;
}
