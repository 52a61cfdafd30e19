#include "recording/robot_messages.hpp"

#include <array>
#include <limits>

#include "core/result.hpp"
#include "recording/internal/cdr.hpp"

namespace amiss::recording {

using internal::CdrIn;
using internal::CdrOut;

namespace {

constexpr std::uint32_t kMostPixels = 1U << 24U, kMostBeams = 1U << 16U;

/// Fast CDR throws exceptions of its own where a message is too short.
template <class Parse>
auto checked(const char* what, const Parse& parse) {
  try {
    return parse();
  } catch (const eprosima::fastcdr::exception::Exception&) {
    throw InputError(std::string("a message of ") + what + " is cut short");
  }
}

void put_matrix(CdrOut& out, const Eigen::Isometry3d& T) { out.array(std::span(T.data(), 16)); }

Eigen::Isometry3d matrix(CdrIn& in) {
  Eigen::Isometry3d T;
  in.array(std::span(T.data(), 16));
  return T;
}

/// The head of an image that must be `encoding`; its pixels follow.
std::size_t image_head(CdrIn& in, const std::string& encoding, std::size_t bytes_per_pixel, CameraIntrinsics& camera) {
  in.header();
  const auto height = in.get<std::uint32_t>(), width = in.get<std::uint32_t>();
  const auto found = in.get<std::string>();
  if (found != encoding) throw InputError("an image is encoded as '" + found + "'; " + encoding + " is needed");
  in.get<std::uint8_t>();
  in.get<std::uint32_t>();
  if (height == 0 || width == 0 || height > kMostPixels / width) throw InputError("an image has no or too many pixels");
  const std::size_t pixels = std::size_t{height} * width;
  if (in.get<std::uint32_t>() != pixels * bytes_per_pixel)
    throw InputError("an image is larger or smaller than it says");
  camera.width = static_cast<int>(width);
  camera.height = static_cast<int>(height);
  return pixels;
}

}  // namespace

std::string setup_message(const Setup& setup) {
  CdrOut out;
  out << setup.seed << setup.method;
  put_matrix(out, setup.T_base_laser.T);
  return out.bytes();
}

Setup parse_setup(std::string_view message) {
  return checked("the setup", [&] {
    CdrIn in(message);
    Setup setup;
    setup.seed = in.get<std::uint64_t>();
    setup.method = in.get<std::string>();
    setup.T_base_laser.T = matrix(in);
    return setup;
  });
}

std::string observation_message(const robot::Observation& o) {
  const LaserScan scan = o.scan ? LaserScan{o.scan->stamp,       o.scan->angle_min_rad, o.scan->angle_step_rad,
                                            o.scan->min_range_m, o.scan->max_range_m,   {}}
                                : LaserScan{};
  CdrOut out;
  out << o.stamp << o.odometry.stamp << o.odometry.T_odom_base << o.head.pan_rad << o.head.tilt_rad << o.bumper;
  out << o.scan.has_value() << scan.stamp << scan.angle_min_rad << scan.angle_step_rad << scan.min_range_m
      << scan.max_range_m;
  out << o.frame.has_value() << (o.frame ? o.frame->frame.stamp : Stamp{});
  put_matrix(out, o.frame ? o.frame->T_base_camera.T : Eigen::Isometry3d::Identity());
  out << (o.frame ? o.frame->T_odom_base : Pose2<Odom, Base>{});
  return out.bytes();
}

robot::Observation parse_observation(std::string_view message) {
  return checked("an observation", [&] {
    CdrIn in(message);
    robot::Observation o;
    o.stamp = in.stamp();
    o.odometry.stamp = in.stamp();
    o.odometry.T_odom_base = in.pose2<Odom, Base>();
    o.head.pan_rad = in.get<double>();
    o.head.tilt_rad = in.get<double>();
    o.bumper = in.get<bool>();
    const bool has_scan = in.get<bool>();
    LaserScan scan;
    scan.stamp = in.stamp();
    scan.angle_min_rad = in.get<double>();
    scan.angle_step_rad = in.get<double>();
    scan.min_range_m = in.get<double>();
    scan.max_range_m = in.get<double>();
    if (has_scan) o.scan = scan;
    const bool has_frame = in.get<bool>();
    robot::CapturedFrame captured;
    captured.frame.stamp = in.stamp();
    captured.T_base_camera.T = matrix(in);
    captured.T_odom_base = in.pose2<Odom, Base>();
    if (has_frame) o.frame = captured;
    return o;
  });
}

void parse_ranges(std::string_view message, LaserScan& scan) {
  checked("a scan", [&] {
    CdrIn in(message);
    in.header();
    std::array<float, 7> unused{};
    in.array(std::span<float>(unused));
    const auto count = in.get<std::uint32_t>();
    if (count > kMostBeams) throw InputError("a scan has more than 65536 beams");
    scan.ranges_m.resize(count);
    in.array(std::span<float>(scan.ranges_m));
  });
}

void parse_depth(std::string_view message, RgbdFrame& frame) {
  checked("a depth image", [&] {
    CdrIn in(message);
    frame.depth_m.resize(image_head(in, "32FC1", sizeof(float), frame.intrinsics));
    in.array(std::span<float>(frame.depth_m));
  });
}

void parse_colour(std::string_view message, RgbdFrame& frame) {
  checked("a colour image", [&] {
    CdrIn in(message);
    CameraIntrinsics size;
    frame.colour.resize(image_head(in, "rgb8", sizeof(Rgb), size));
    if (frame.colour.size() != frame.depth_m.size()) throw InputError("colour and depth differ in size");
    in.array(std::span(reinterpret_cast<std::uint8_t*>(frame.colour.data()), frame.colour.size() * sizeof(Rgb)));
  });
}

void parse_camera_info(std::string_view message, CameraIntrinsics& camera) {
  checked("a camera's numbers", [&] {
    CdrIn in(message);
    in.header();
    in.get<std::uint32_t>();
    in.get<std::uint32_t>();
    in.get<std::string>();
    const auto coefficients = in.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < coefficients; ++i) in.get<double>();
    std::array<double, 9> k{};
    in.array(std::span<double>(k));
    camera.fx = k[0];
    camera.cx = k[2];
    camera.fy = k[4];
    camera.cy = k[5];
  });
}

std::string decision_message(const Decision& decision) {
  CdrOut out;
  out << static_cast<std::uint8_t>(decision.kind) << static_cast<std::int32_t>(decision.region);
  return out.bytes();
}

Decision parse_decision(std::string_view message) {
  return checked("a decision", [&] {
    CdrIn in(message);
    const auto kind = in.get<std::uint8_t>();
    if (kind > 2) throw InputError("a decision is of a kind that is not known");
    return Decision{static_cast<Decision::Kind>(kind), in.get<std::int32_t>()};
  });
}

}  // namespace amiss::recording
