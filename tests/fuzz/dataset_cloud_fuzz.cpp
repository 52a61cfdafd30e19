// libFuzzer target: any bytes as a PLY or PCD file end with a cloud or an InputError, never with a crash; what was read
// is written and read again with as many points.
#include <cstdint>
#include <string_view>

#include "core/result.hpp"
#include "dataset/cloud_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amiss::dataset;
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  try {
    const bool ply = bytes.starts_with("ply");
    const CloudFile file = ply ? parse_ply(bytes, "fuzz") : parse_pcd(bytes, "fuzz");
    const std::string again = ply ? ply_bytes(file) : pcd_bytes(file);
    const CloudFile reread = ply ? parse_ply(again, "again") : parse_pcd(again, "again");
    if (reread.cloud().points.size() != file.cloud().points.size()) __builtin_trap();
    if (reread.mesh.triangles != file.mesh.triangles) __builtin_trap();
  } catch (const amiss::InputError&) {  // what bad input should end with
  }
  return 0;
}
