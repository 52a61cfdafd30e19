#include "dataset/internal/ros_messages.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "core/result.hpp"
#include "dataset/internal/bytes.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {
namespace {

constexpr std::uint32_t kMostEdge = 8192;  // pixels
constexpr std::size_t kDepthBytes = 2, kFloatBytes = 4;
constexpr std::size_t kPackedDepthHead = 12;  // a kind and two numbers that only 32FC1 needs
constexpr std::uint32_t kMostBeams = 1U << 16U;

Stamp take_stamp(ByteReader& reader) {
  const auto whole_s = reader.get<std::uint32_t>(), rest_ns = reader.get<std::uint32_t>();
  return Stamp(std::chrono::seconds(whole_s) + std::chrono::nanoseconds(rest_ns));
}

std::string frame_name(std::string_view name) { return std::string(name.starts_with('/') ? name.substr(1) : name); }

RosHeader take_header(ByteReader& reader) {
  reader.get<std::uint32_t>();  // a running number
  const Stamp stamp = take_stamp(reader);
  return {stamp, frame_name(reader.counted())};
}

struct RawImage {
  int width = 0, height = 0;
  std::size_t step = 0;  // bytes of a row
  std::string_view encoding, data;
  bool big_endian = false;

  [[nodiscard]] std::string_view row(int v) const { return data.substr(static_cast<std::size_t>(v) * step, step); }
};

RawImage take_image(std::string_view message, const std::string& name) {
  ByteReader reader(message, name);
  take_header(reader);
  RawImage image;
  const auto height = reader.get<std::uint32_t>(), width = reader.get<std::uint32_t>();
  if (width < 1 || height < 1 || width > kMostEdge || height > kMostEdge) {
    throw InputError(name + ": an image is " + std::to_string(width) + " x " + std::to_string(height) +
                     "; 1 to 8192 pixels a side are allowed");
  }
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.encoding = reader.counted();
  image.big_endian = reader.get<std::uint8_t>() != 0;
  image.step = reader.get<std::uint32_t>();
  image.data = reader.counted();
  if (image.data.size() / height < image.step) throw InputError(name + ": an image has fewer bytes than its rows");
  return image;
}

void need_row(const RawImage& image, std::size_t bytes_a_pixel, const std::string& name) {
  if (image.step < bytes_a_pixel * static_cast<std::size_t>(image.width)) {
    throw InputError(name + ": the rows of an image are shorter than its width");
  }
}

[[noreturn]] void refuse_encoding(const RawImage& image, const char* allowed, const std::string& name) {
  throw InputError(name + ": an image is encoded as '" + std::string(image.encoding.substr(0, 30)) + "'; " + allowed +
                   " are allowed");
}

/// Where red, green and blue stand in a pixel, and how many bytes it has.
struct ColourOrder {
  std::string_view encoding;
  std::size_t red, green, blue, bytes;
};
constexpr std::array<ColourOrder, 5> kOrders{
    {{"rgb8", 0, 1, 2, 3}, {"bgr8", 2, 1, 0, 3}, {"rgba8", 0, 1, 2, 4}, {"bgra8", 2, 1, 0, 4}, {"mono8", 0, 0, 0, 1}}};

bool is_depth(std::string_view encoding) { return encoding == "16UC1" || encoding == "mono16" || encoding == "32FC1"; }

Eigen::Isometry3d take_pose(ByteReader& reader, const std::string& what) {
  std::array<double, 7> v{};
  for (double& value : v) value = reader.get<double>();
  const Eigen::Quaterniond turn(v[6], v[3], v[4], v[5]);
  const double length = turn.norm();
  if (!(length > 0.5 && length < 2.0) || !std::isfinite(v[0] + v[1] + v[2])) {
    throw InputError(what + " is no rigid motion");
  }
  return Eigen::Translation3d(v[0], v[1], v[2]) * turn.normalized();
}

float depth_at(const char* at, const RawImage& image, double scale) {
  if (image.encoding == "32FC1") {
    float metres = 0.0F;
    std::memcpy(&metres, at, kFloatBytes);
    return std::isfinite(metres) && metres > 0.0F ? metres : std::numeric_limits<float>::quiet_NaN();
  }
  std::uint16_t units = 0;
  std::memcpy(&units, at, kDepthBytes);
  if (image.big_endian) units = static_cast<std::uint16_t>(units << 8U | units >> 8U);
  return units == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(units / scale);
}

}  // namespace

Pose2<Odom, Base> on_floor(const Eigen::Isometry3d& T) {
  return {T.translation().x(), T.translation().y(), std::atan2(T.linear()(1, 0), T.linear()(0, 0))};
}

RosHeader parse_ros_header(std::string_view message, const std::string& name) {
  ByteReader reader(message, name);
  return take_header(reader);
}

bool is_ros_depth(std::string_view message, const std::string& name) {
  return is_depth(take_image(message, name).encoding);
}

ColourImage parse_ros_colour(std::string_view message, const std::string& name) {
  const RawImage raw = take_image(message, name);
  const auto* order =
      std::find_if(kOrders.begin(), kOrders.end(), [&](const ColourOrder& o) { return o.encoding == raw.encoding; });
  if (order == kOrders.end()) refuse_encoding(raw, "rgb8, bgr8, rgba8, bgra8 and mono8", name);
  need_row(raw, order->bytes, name);
  ColourImage image{raw.width, raw.height, {}};
  for (int v = 0; v < raw.height; ++v) {
    const std::string_view row = raw.row(v);
    for (std::size_t at = 0; at < order->bytes * static_cast<std::size_t>(raw.width); at += order->bytes) {
      const auto value = [&](std::size_t channel) { return static_cast<std::uint8_t>(row[at + channel]); };
      image.pixels.push_back({value(order->red), value(order->green), value(order->blue)});
    }
  }
  return image;
}

DepthImage parse_ros_depth(std::string_view message, double scale, const std::string& name) {
  const RawImage raw = take_image(message, name);
  if (!is_depth(raw.encoding)) refuse_encoding(raw, "16UC1, mono16 and 32FC1", name);
  const std::size_t bytes = raw.encoding == "32FC1" ? kFloatBytes : kDepthBytes;
  if (raw.big_endian && bytes == kFloatBytes) throw InputError(name + ": big-endian 32FC1 images are not read");
  need_row(raw, bytes, name);
  DepthImage image{raw.width, raw.height, {}};
  for (int v = 0; v < raw.height; ++v) {
    const char* row = raw.row(v).data();
    for (std::size_t u = 0; u < static_cast<std::size_t>(raw.width); ++u) {
      image.depth_m.push_back(depth_at(row + u * bytes, raw, scale));
    }
  }
  return image;
}

ColourImage parse_ros_packed_colour(std::string_view message, const std::string& name) {
  ByteReader reader(message, name);
  take_header(reader);
  reader.counted();  // what was packed, and how
  return decode_colour(std::string(reader.counted()), name);
}

DepthImage parse_ros_packed_depth(std::string_view message, double scale, const std::string& name) {
  ByteReader reader(message, name);
  take_header(reader);
  const std::string_view format = reader.counted();
  if (!format.starts_with("16UC1;") || format.find("rvl") != std::string_view::npos) {
    throw InputError(name + ": depth is packed as '" + shown(format) + "'; '16UC1; compressedDepth' (png) is allowed");
  }
  const std::string_view data = reader.counted();
  return decode_depth(std::string(data.substr(std::min(data.size(), kPackedDepthHead))), scale, name);
}

CameraIntrinsics parse_ros_camera(std::string_view message, const std::string& name) {
  ByteReader reader(message, name);
  take_header(reader);
  const auto height = reader.get<std::uint32_t>(), width = reader.get<std::uint32_t>();
  reader.counted();                                                        // model of the distortion
  reader.take(sizeof(double) * std::size_t{reader.get<std::uint32_t>()});  // and its coefficients
  std::array<double, 9> k{}, r{};
  std::array<double, 12> p{};
  for (double& value : k) value = reader.get<double>();
  for (double& value : r) value = reader.get<double>();
  for (double& value : p) value = reader.get<double>();
  const bool rectified = p[0] > 0.0;
  const std::array<double, 4> f =
      rectified ? std::array<double, 4>{p[0], p[5], p[2], p[6]} : std::array<double, 4>{k[0], k[4], k[2], k[5]};
  const bool good = width >= 1 && height >= 1 && width <= kMostEdge && height <= kMostEdge && f[0] >= 1.0 &&
                    f[1] >= 1.0 && std::isfinite(f[0] + f[1] + f[2] + f[3]);
  if (!good) throw InputError(name + ": a CameraInfo message has no focal lengths or no size");
  return {static_cast<int>(width), static_cast<int>(height), f[0], f[1], f[2], f[3]};
}

std::vector<RosTransform> parse_ros_transforms(std::string_view message, const std::string& name) {
  ByteReader reader(message, name);
  std::vector<RosTransform> transforms;
  for (auto left = reader.get<std::uint32_t>(); left > 0; --left) {
    RosTransform one;
    const RosHeader header = take_header(reader);
    one.stamp = header.stamp;
    one.parent = header.frame;
    one.child = frame_name(reader.counted());
    one.T_parent_child =
        take_pose(reader, name + ": the transform from " + one.child.substr(0, 60) + " to " + one.parent.substr(0, 60));
    transforms.push_back(std::move(one));
  }
  return transforms;
}

RosScan parse_ros_scan(std::string_view message, const std::string& name) {
  ByteReader reader(message, name);
  RosScan scan;
  const RosHeader header = take_header(reader);
  scan.frame = header.frame;
  const auto first_rad = reader.get<float>();
  reader.get<float>();  // angle of the last beam
  const auto step_rad = reader.get<float>();
  reader.get<float>();  // time between two beams
  reader.get<float>();  // and between two scans
  const auto least_m = reader.get<float>(), most_m = reader.get<float>();
  const auto beams = reader.get<std::uint32_t>();
  if (!std::isfinite(first_rad + step_rad + least_m) || !(most_m > least_m) || beams < 1 || beams > kMostBeams) {
    throw InputError(name + ": a scan has no beams, too many, or angles and ranges that make no sense");
  }
  scan.scan = {header.stamp, first_rad, step_rad, least_m, most_m, std::vector<float>(beams)};
  for (float& range : scan.scan.ranges_m) {
    range = reader.get<float>();
    if (!(range >= least_m && range <= most_m && std::isfinite(range))) range = std::numeric_limits<float>::quiet_NaN();
  }
  return scan;
}

RosOdometry parse_ros_odometry(std::string_view message, const std::string& name) {
  ByteReader reader(message, name);
  const RosHeader header = take_header(reader);
  const std::string child = frame_name(reader.counted());
  const Eigen::Isometry3d T = take_pose(reader, name + ": a pose of odometry");
  return {header.frame, child, {header.stamp, on_floor(T)}};
}

}  // namespace amiss::dataset
