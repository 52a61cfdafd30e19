// CDR as ROS 2 writes it (little-endian, with the encapsulation in front), by Fast CDR.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <Eigen/Geometry>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/frames.hpp"
#include "core/stamp.hpp"

namespace amiss::recording::internal {

class CdrOut {
 public:
  CdrOut() { cdr_.serialize_encapsulation(); }
  CdrOut(const CdrOut&) = delete;  // cdr_ writes to its own buffer_
  CdrOut& operator=(const CdrOut&) = delete;

  template <class Value>
  requires std::is_arithmetic_v<Value> CdrOut& operator<<(Value value) {
    align(sizeof value);
    cdr_ << value;
    return *this;
  }
  CdrOut& operator<<(std::string_view text) {
    align(sizeof(std::uint32_t));  // of the length
    cdr_ << std::string(text);
    return *this;
  }
  CdrOut& operator<<(const char* text) { return *this << std::string_view(text); }
  CdrOut& operator<<(Stamp stamp) {
    const std::int64_t ns = stamp.time_since_epoch().count();
    return *this << static_cast<std::int32_t>(ns / 1'000'000'000) << static_cast<std::uint32_t>(ns % 1'000'000'000);
  }
  CdrOut& operator<<(const Eigen::Vector3d& v) { return *this << v.x() << v.y() << v.z(); }
  CdrOut& operator<<(const Eigen::Quaterniond& q) { return *this << q.x() << q.y() << q.z() << q.w(); }
  /// Position and orientation: geometry_msgs/Pose and Transform.
  CdrOut& operator<<(const Eigen::Isometry3d& T) {
    return *this << Eigen::Vector3d(T.translation()) << Eigen::Quaterniond(T.linear());
  }
  template <class To, class From>
  CdrOut& operator<<(const Pose2<To, From>& pose) {
    return *this << pose.x_m << pose.y_m << pose.yaw_rad;
  }
  CdrOut& size(std::size_t count) { return *this << static_cast<std::uint32_t>(count); }
  /// The elements without their number.
  template <class Value>
  CdrOut& array(std::span<const Value> values) {
    if (values.empty()) return *this;
    align(sizeof(Value));
    cdr_.serializeArray(values.data(), values.size());
    return *this;
  }
  template <class Value>
  CdrOut& sequence(std::span<const Value> values) {
    return size(values.size()).array(values);
  }
  /// std_msgs/Header
  CdrOut& header(Stamp stamp, std::string_view frame) { return *this << stamp << frame; }

  [[nodiscard]] std::string bytes() { return {buffer_.getBuffer(), cdr_.getSerializedDataLength()}; }

 private:
  /// Zeros up to a multiple, counted from behind the encapsulation: Fast CDR leaves what lies in memory there.
  void align(std::size_t bytes) {
    constexpr std::size_t kEncapsulation = 4;
    while ((cdr_.getSerializedDataLength() - kEncapsulation) % bytes != 0) cdr_ << std::uint8_t{0};
  }

  eprosima::fastcdr::FastBuffer buffer_;
  eprosima::fastcdr::Cdr cdr_{buffer_, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS, eprosima::fastcdr::Cdr::DDS_CDR};
};

/// Throws eprosima::fastcdr::exception::Exception where there are too few bytes.
class CdrIn {
 public:
  explicit CdrIn(std::string_view bytes) : bytes_(bytes), buffer_(bytes_.data(), bytes_.size()) {
    cdr_.read_encapsulation();
  }
  CdrIn(const CdrIn&) = delete;
  CdrIn& operator=(const CdrIn&) = delete;

  template <class Value>
  Value get() {
    Value value{};
    cdr_ >> value;
    return value;
  }
  Stamp stamp() {
    const auto seconds = get<std::int32_t>();
    const auto nanoseconds = get<std::uint32_t>();
    return Stamp{std::chrono::seconds(seconds) + std::chrono::nanoseconds(nanoseconds)};
  }
  template <class To, class From>
  Pose2<To, From> pose2() {
    const auto x = get<double>(), y = get<double>();
    return {x, y, get<double>()};
  }
  template <class Value>
  void array(std::span<Value> values) {
    if (!values.empty()) cdr_.deserializeArray(values.data(), values.size());
  }
  void header() {
    stamp();
    get<std::string>();
  }

 private:
  std::string bytes_;  // Fast CDR wants them writable
  eprosima::fastcdr::FastBuffer buffer_;
  eprosima::fastcdr::Cdr cdr_{buffer_, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS, eprosima::fastcdr::Cdr::DDS_CDR};
};

}  // namespace amiss::recording::internal
