#include "recording/ros_messages.hpp"

#include <algorithm>
#include <array>

#include "recording/internal/cdr.hpp"

namespace amiss::recording {

using internal::CdrOut;

namespace {

constexpr std::array<double, 36> kNoCovariance{};
constexpr std::uint8_t kLogInfo = 20, kFloat32 = 7;

std::string image(const RgbdFrame& frame, const char* encoding, std::size_t bytes_per_pixel, const void* pixels) {
  const CameraIntrinsics& c = frame.intrinsics;
  const auto width = static_cast<std::size_t>(c.width), height = static_cast<std::size_t>(c.height);
  CdrOut out;
  out.header(frame.stamp, kCameraFrame);
  out.size(height).size(width) << encoding << std::uint8_t{0};
  out.size(width * bytes_per_pixel);
  out.sequence(std::span(static_cast<const std::uint8_t*>(pixels), width * height * bytes_per_pixel));
  return out.bytes();
}

struct MarkerLook {
  std::int32_t type;
  Eigen::Vector3d size_m;
  std::array<float, 4> rgba;
};
constexpr std::int32_t kSphere = 2, kCylinder = 3, kText = 9, kAdd = 0, kDeleteAll = 3;

void put_marker(CdrOut& out, Stamp stamp, const char* name_space, int id, std::int32_t action,
                const Eigen::Vector3d& centre_map, const MarkerLook& look, const std::string& text) {
  out.header(stamp, kMapFrame) << name_space << static_cast<std::int32_t>(id) << look.type << action << centre_map
                               << Eigen::Quaterniond::Identity() << look.size_m;
  for (const float channel : look.rgba) out << channel;
  out << std::int32_t{0} << std::uint32_t{0} << false;  // lifetime: for ever; frame_locked
  out.size(0).size(0) << "";                            // points, colors, texture_resource
  out.header(Stamp{}, "") << "";                        // texture
  out.size(0).size(0) << text << ""
                      << "";  // texture data, uv_coordinates; mesh_resource, mesh_file
  out.size(0) << false;
}

/// Examined regions are green, open ones orange.
MarkerLook look_of(const knowledge::Region& region) {
  const knowledge::Cylinder& c = region.cylinder;
  const std::array<float, 4> rgba =
      region.examined ? std::array{0.0F, 0.62F, 0.45F, 0.5F} : std::array{0.9F, 0.62F, 0.0F, 0.5F};
  return {kCylinder, {2.0 * c.radius_m, 2.0 * c.radius_m, std::max(0.01, c.z_high_m - c.z_low_m)}, rgba};
}

}  // namespace

std::string transforms_message(Stamp stamp, const std::vector<NamedTransform>& transforms) {
  CdrOut out;
  out.size(transforms.size());
  for (const NamedTransform& t : transforms) out.header(stamp, t.parent) << t.child << t.T_parent_child;
  return out.bytes();
}

std::string odometry_message(const Odometry& odometry) {
  CdrOut out;
  out.header(odometry.stamp, kOdomFrame) << kBaseFrame << odometry.T_odom_base.lift().T;
  out.array(std::span<const double>(kNoCovariance)) << Eigen::Vector3d::Zero().eval() << Eigen::Vector3d::Zero().eval();
  out.array(std::span<const double>(kNoCovariance));
  return out.bytes();
}

std::string scan_message(const LaserScan& scan) {
  const double last = scan.angle_min_rad + scan.angle_step_rad * (static_cast<double>(scan.ranges_m.size()) - 1.0);
  CdrOut out;
  out.header(scan.stamp, kLaserFrame);
  for (const double value :
       {scan.angle_min_rad, last, scan.angle_step_rad, 0.0, 0.0, scan.min_range_m, scan.max_range_m})
    out << static_cast<float>(value);
  out.sequence(std::span<const float>(scan.ranges_m)).size(0);
  return out.bytes();
}

std::string depth_message(const RgbdFrame& frame) { return image(frame, "32FC1", sizeof(float), frame.depth_m.data()); }

std::string colour_message(const RgbdFrame& frame) {
  static_assert(sizeof(Rgb) == 3);
  return image(frame, "rgb8", sizeof(Rgb), frame.colour.data());
}

std::string colour_jpeg_message(Stamp stamp, std::string_view jpeg) {
  CdrOut out;
  out.header(stamp, kCameraFrame) << "jpeg";
  out.sequence(std::span(reinterpret_cast<const std::uint8_t*>(jpeg.data()), jpeg.size()));
  return out.bytes();
}

std::string camera_info_message(Stamp stamp, const CameraIntrinsics& c) {
  const std::array<double, 9> k{c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}, r{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<double, 12> p{c.fx, 0, c.cx, 0, 0, c.fy, c.cy, 0, 0, 0, 1, 0};
  const std::array<double, 5> no_distortion{};
  CdrOut out;
  out.header(stamp, kCameraFrame);
  out.size(static_cast<std::size_t>(c.height)).size(static_cast<std::size_t>(c.width)) << "plumb_bob";
  out.sequence(std::span<const double>(no_distortion)).array(std::span<const double>(k));
  out.array(std::span<const double>(r)).array(std::span<const double>(p));
  out.size(0).size(0).size(0).size(0).size(0).size(0) << false;  // binning, region of interest
  return out.bytes();
}

std::string grid_message(Stamp stamp, const FloorGrid& grid) {
  std::vector<std::int8_t> cells;
  for (const Occupancy value : grid.cells()) {
    cells.push_back(value == Occupancy::kUnknown ? std::int8_t{-1}
                    : value == Occupancy::kFree  ? std::int8_t{0}
                                                 : std::int8_t{100});
  }
  const Eigen::Vector3d origin(grid.origin_m().x(), grid.origin_m().y(), 0.0);
  CdrOut out;
  out.header(stamp, kMapFrame) << stamp << static_cast<float>(grid.resolution_m());
  out.size(static_cast<std::size_t>(grid.width())).size(static_cast<std::size_t>(grid.height()))
      << origin << Eigen::Quaterniond::Identity();
  out.sequence(std::span<const std::int8_t>(cells));
  return out.bytes();
}

std::string cloud_message(Stamp stamp, std::span<const Eigen::Vector3f> points_map) {
  constexpr std::uint32_t kStep = 3 * sizeof(float);
  CdrOut out;
  out.header(stamp, kMapFrame);
  out.size(1).size(points_map.size()).size(3);
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z"}) {
    out << name << offset << kFloat32 << std::uint32_t{1};
    offset += sizeof(float);
  }
  out << false << kStep;
  out.size(kStep * points_map.size());
  out.sequence(std::span(reinterpret_cast<const std::uint8_t*>(points_map.data()), kStep * points_map.size())) << true;
  return out.bytes();
}

std::string path_message(Stamp stamp, const std::vector<Eigen::Vector2d>& points_map) {
  CdrOut out;
  out.header(stamp, kMapFrame).size(points_map.size());
  for (const Eigen::Vector2d& p : points_map) {
    out.header(stamp, kMapFrame) << Eigen::Vector3d(p.x(), p.y(), 0.0) << Eigen::Quaterniond::Identity();
  }
  return out.bytes();
}

std::string text_message(std::string_view text) {
  CdrOut out;
  out << text;
  return out.bytes();
}

std::string log_message(Stamp stamp, std::string_view text) {
  CdrOut out;
  out << stamp << kLogInfo << "amiss" << text << ""
      << "" << std::uint32_t{0};
  return out.bytes();
}

std::string markers_message(Stamp stamp, const knowledge::Knowledge& knowledge) {
  const auto shown = std::count_if(knowledge.regions.begin(), knowledge.regions.end(),
                                   [](const knowledge::Region& r) { return !r.withdrawn; });
  CdrOut out;
  out.size(1 + 2 * static_cast<std::size_t>(shown) + knowledge.objects.size());
  put_marker(out, stamp, "", 0, kDeleteAll, Eigen::Vector3d::Zero(), {kCylinder, Eigen::Vector3d::Zero(), {}}, "");
  for (const knowledge::Region& r : knowledge.regions) {
    if (r.withdrawn) continue;
    const knowledge::Cylinder& c = r.cylinder;
    const Eigen::Vector3d centre(c.centre_map.x(), c.centre_map.y(), 0.5 * (c.z_low_m + c.z_high_m));
    put_marker(out, stamp, "regions", r.id, kAdd, centre, look_of(r), "");
    put_marker(out, stamp, "region_ids", r.id, kAdd, centre + Eigen::Vector3d(0, 0, 0.3),
               {kText, {0.0, 0.0, 0.15}, {0.0F, 0.0F, 0.0F, 1.0F}}, std::to_string(r.id));
  }
  for (const knowledge::Object& o : knowledge.objects) {
    const MarkerLook look{kSphere, o.size_m.cwiseMax(0.02), {0.0F, 0.45F, 0.7F, 0.8F}};
    put_marker(out, stamp, "objects", o.id, kAdd, o.centre_map, look, "");
  }
  return out.bytes();
}

}  // namespace amiss::recording
