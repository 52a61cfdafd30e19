// libFuzzer target: any bytes as map.yaml and map.pgm, divided by a zero byte, end with a grid or an InputError.
#include <cstdint>
#include <string_view>

#include "core/result.hpp"
#include "mapping/floor_grid_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amiss::mapping;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t border = text.find('\0');
  FloorGridHeader header;
  try {
    header = parse_floor_grid_header(text.substr(0, border), "fuzz.yaml");
  } catch (const amiss::InputError&) {  // what bad input should end with
  }
  try {
    (void)parse_floor_grid(header, border == std::string_view::npos ? text : text.substr(border + 1), "fuzz.pgm");
  } catch (const amiss::InputError&) {
  }
  return 0;
}
