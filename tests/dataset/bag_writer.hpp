// Writes ROS 1 bags for tests, record by record as the format's page has them. ROS itself makes the bytes of the
// messages and packs lz4 chunks; its headers do not compile as C++20, so they stay in the source, which is C++17.
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
/// CompressedImage.
struct BagPacked {
  double stamp_s = 0.0;
  std::string frame, format, data;
};
struct BagTransform {
  double stamp_s = 0.0;
  std::string parent, child;
  double x_m = 0.0, yaw_rad = 0.0;
};
/// Turned by a unit quaternion.
struct BagPose {
  double stamp_s = 0.0;
  std::string parent, child;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0, qx = 0.0, qy = 0.0, qz = 0.0, qw = 1.0;
};
struct BagScan {
  double stamp_s = 0.0;
  std::string frame;
  double angle_min_rad = 0.0, angle_step_rad = 0.0, min_range_m = 0.0, max_range_m = 0.0;
  std::vector<float> ranges_m;
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
  void write(const std::string& topic, const BagPacked& image);
  void write(const std::string& topic, const BagTransform& transform);
  void write(const std::string& topic, const BagCamera& camera);
  void write(const std::string& topic, const BagScan& scan);
  void write(const std::string& topic, const BagPose& transform);
  void write_odometry(const std::string& topic, const BagPose& pose);
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class Message>
  void add(const std::string& topic, const Message& message);
  void add_bytes(const std::string& topic, const std::vector<std::string>& type, const std::string& message);
  [[nodiscard]] std::string packed(std::string chunk) const;

  std::string compression_, bytes_;
  std::map<std::string, std::uint32_t> connections_;
};

}  // namespace amiss::test
