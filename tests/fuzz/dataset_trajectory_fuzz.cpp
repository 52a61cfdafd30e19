// libFuzzer target: any bytes as poses end with poses or an InputError; TUM poses that were read are written and read
// again with the same times.
#include <cstdint>
#include <string_view>

#include "core/result.hpp"
#include "dataset/trajectory_files.hpp"

namespace {

template <class Read>
void attempt(Read read) {
  try {
    read();
  } catch (const amiss::InputError&) {  // what bad input should end with
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amiss::dataset;
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  attempt([&] { (void)parse_open3d_log(bytes, "fuzz"); });
  attempt([&] { (void)parse_pose_matrix(bytes, "fuzz"); });
  attempt([&] {
    const auto poses = parse_tum_trajectory(bytes, "fuzz");
    const auto again = parse_tum_trajectory(tum_trajectory_bytes(poses), "again");
    if (again.size() != poses.size()) __builtin_trap();
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (again[i].stamp != poses[i].stamp) __builtin_trap();
    }
  });
  return 0;
}
