// The bytes of a file that may be gzipped, from front to back.
// InputError "FILE: ..." where it is not there or its packed data was damaged; BrokenOff where it ends in the middle of
// what is asked for. Memory grows with the bytes that are there, not with those that are asked for.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>

namespace amiss::recording::internal {

struct BrokenOff {};

class GzBytes {
 public:
  explicit GzBytes(const std::filesystem::path& file);
  ~GzBytes();
  GzBytes(const GzBytes&) = delete;
  GzBytes& operator=(const GzBytes&) = delete;

  std::string take(std::uint64_t size);
  template <class Number>
  Number number() {
    Number value{};
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  /// Nothing more comes; BrokenOff where the packed data has no end.
  bool at_end();
  [[nodiscard]] std::uint64_t at() const { return at_; }  // unpacked

 private:
  struct Stream;
  [[nodiscard]] bool is_cut() const;  // its packed data has no end; InputError where it was damaged

  std::string name_;
  std::unique_ptr<Stream> stream_;
  std::uint64_t at_ = 0;
};

}  // namespace amiss::recording::internal
