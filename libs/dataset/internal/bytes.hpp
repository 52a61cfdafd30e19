// Little-endian values from bytes that are not believed: every step is held against what is there.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace amiss::dataset {

static_assert(std::endian::native == std::endian::little);

class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  template <class T>
  T get() {
    const std::string_view taken = take(sizeof(T));
    T value{};
    std::memcpy(&value, taken.data(), sizeof(T));
    return value;
  }
  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) throw InputError(name_ + ": ends in the middle of a message");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  /// Bytes behind their number, as ROS writes strings and arrays of bytes.
  std::string_view counted() { return take(get<std::uint32_t>()); }
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  const std::string& name_;
};

}  // namespace amiss::dataset
