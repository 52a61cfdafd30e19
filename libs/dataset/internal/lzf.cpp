#include "dataset/internal/lzf.hpp"

#include "core/result.hpp"

namespace amiss::dataset {

std::string lzf_expanded(std::string_view packed, std::size_t size, const std::string& name) {
  const auto broken = [&name]() { return InputError(name + ": its compressed data are broken (LZF)"); };
  std::string bytes;
  bytes.reserve(size);
  std::size_t at = 0;
  const auto next = [&]() {
    if (at >= packed.size()) throw broken();
    return static_cast<std::size_t>(static_cast<unsigned char>(packed[at++]));
  };
  while (at < packed.size()) {
    const std::size_t control = next();
    if (control < 32) {
      const std::size_t run = control + 1;
      if (run > packed.size() - at || run > size - bytes.size()) throw broken();
      bytes.append(packed.substr(at, run));
      at += run;
      continue;
    }
    std::size_t length = control >> 5U;
    if (length == 7) length += next();
    length += 2;
    const std::size_t back = ((control & 31U) << 8U) + next() + 1;
    if (back > bytes.size() || length > size - bytes.size()) throw broken();
    for (std::size_t from = bytes.size() - back, i = 0; i < length; ++i) bytes += bytes[from + i];
  }
  if (bytes.size() != size) throw broken();
  return bytes;
}

}  // namespace amiss::dataset
