// Writes ROS 1 bags for tests, record by record as the format's page has them. ROS itself makes the bytes of the messages
// and packs lz4 chunks; its headers do not compile as C++20, so they stay in the source, which is C++17.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace amiss::test {

struct BagImage {
  double stamp_s = 0.0;
  std::string frame, encoding;
  std::uint32_t width = 0, height = 0, step = 0;
  std::vector<std::uint8_t> data;
};
struct BagTransform {
  double stamp_s = 0.0;
  std::string parent, child;
  double x_m = 0.0, yaw_rad = 0.0;
};
struct BagCamera {
  std::uint32_t width = 0, height = 0;
  double k_fx = 0.0, p_fx = 0.0, p_fy = 0.0, p_cx = 0.0, p_cy = 0.0;
};

/// Each message gets a chunk of its own, as large images do.
class BagWriter {
 public:
  explicit BagWriter(std::string compression);  // none, bz2, lz4; another word is written over plain bytes
  void write(const std::string& topic, const BagImage& image);
  void write(const std::string& topic, const BagTransform& transform);
  void write(const std::string& topic, const BagCamera& camera);
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class Message>
  void add(const std::string& topic, const Message& message);
  [[nodiscard]] std::string packed(std::string chunk) const;

  std::string compression_, bytes_;
  std::map<std::string, std::uint32_t> connections_;
};

}  // namespace amiss::test
