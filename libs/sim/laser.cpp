#include "sim/laser.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "sim/internal/segment_grid.hpp"
#include "sim/internal/tessellate.hpp"

namespace amiss::sim {
namespace {

constexpr double kSolidAlpha = 0.99;  // what one can see through lets the beam pass

/// Where the edge a-b meets the plane z = height; its ends lie on different sides.
Eigen::Vector2d crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double height_m) {
  const double part = (height_m - a.z()) / (b.z() - a.z());
  return (a + part * (b - a)).head<2>();
}

void cut(const internal::Triangle& triangle, double height_m, std::vector<Segment2>& out) {
  std::array<Eigen::Vector2d, 2> ends;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d &a = triangle[i], &b = triangle[(i + 1) % 3];
    if ((a.z() >= height_m) != (b.z() >= height_m) && found < 2) ends[found++] = crossing(a, b, height_m);
  }
  if (found == 2 && (ends[0] - ends[1]).squaredNorm() > 1e-12) out.push_back({ends[0], ends[1]});
}

std::vector<Segment2> static_segments(const world::World& world, double height_m) {
  std::vector<Segment2> out;
  for (const world::Body& body : world.bodies) {
    if (!body.is_static) continue;
    const std::vector<Segment2> cuts = slice(body, body.pose, height_m);
    out.insert(out.end(), cuts.begin(), cuts.end());
  }
  return out;
}

}  // namespace

void describe(ParamTable& table, LaserParams& params) {
  table.number("laser.period", params.period_s, "s", 0.02, 10.0, "time between two scans");
  table.number("laser.half_angle", params.half_angle_rad, "deg", 10.0, 179.0, "to both sides of straight ahead");
  table.integer("laser.beams", params.beams, 2, 5000, "of one scan");
  table.number("laser.min_range", params.min_range_m, "m", 0.0, 5.0, "nothing comes back from nearer");
  table.number("laser.max_range", params.max_range_m, "m", 0.1, 100.0, "nothing comes back from farther");
  table.number("laser.sigma", params.sigma_m, "m", 0.0, 0.5, "standard deviation of a range");
}

std::vector<Segment2> slice(const world::Body& body, const Transform<amiss::World, Object>& pose, double height_m) {
  std::vector<Segment2> out;
  for (const world::Shape& shape : body.visuals) {
    if (static_cast<double>(shape.material.alpha) < kSolidAlpha) continue;
    const Eigen::Isometry3d T = pose.T * shape.T_body_shape;
    for (internal::Triangle& triangle : internal::tessellate(shape.geometry)) {
      for (Eigen::Vector3d& corner : triangle) corner = T * corner;
      cut(triangle, height_m, out);
    }
  }
  return out;
}

struct LaserScanner::Impl {
  LaserParams params;
  double height_m;
  internal::SegmentGrid fixed;
  std::vector<Eigen::Vector2d> directions;              // of the beams in the laser frame
  std::map<std::size_t, std::vector<Segment2>> moving;  // in the world frame

  Impl(const world::World& world, double height, const LaserParams& wanted)
      : params(wanted), height_m(height), fixed(static_segments(world, height)) {
    for (int i = 0; i < params.beams; ++i) {
      const double angle = -params.half_angle_rad + i * angle_step_rad();
      directions.emplace_back(std::cos(angle), std::sin(angle));
    }
  }
  [[nodiscard]] double angle_step_rad() const { return 2.0 * params.half_angle_rad / (params.beams - 1); }
  void shade(const Segment2& segment, std::vector<double>& ranges) const;
};

/// Shortens the beams that a segment, in the laser frame, is in the way of.
void LaserScanner::Impl::shade(const Segment2& segment, std::vector<double>& ranges) const {
  const double start = std::atan2(segment.a.y(), segment.a.x());
  const double sweep = wrap_angle(std::atan2(segment.b.y(), segment.b.x()) - start);
  const double low = std::min(start, start + sweep), high = std::max(start, start + sweep);
  for (const double turn : {-2.0 * std::numbers::pi, 0.0, 2.0 * std::numbers::pi}) {
    const double first = std::ceil((low + turn + params.half_angle_rad) / angle_step_rad() - 1e-9);
    const double last = std::floor((high + turn + params.half_angle_rad) / angle_step_rad() + 1e-9);
    for (int i = std::max(0, static_cast<int>(first)); i <= std::min(params.beams - 1, static_cast<int>(last)); ++i) {
      const auto beam = static_cast<std::size_t>(i);
      ranges[beam] = std::min(ranges[beam], internal::hit(segment, Eigen::Vector2d::Zero(), directions[beam]));
    }
  }
}

LaserScanner::LaserScanner(const world::World& world, double height_m, const LaserParams& params)
    : impl_(std::make_unique<Impl>(world, height_m, params)) {}
LaserScanner::~LaserScanner() = default;
LaserScanner::LaserScanner(LaserScanner&&) noexcept = default;
LaserScanner& LaserScanner::operator=(LaserScanner&&) noexcept = default;

void LaserScanner::set_moving(std::size_t number, const world::Body& body,
                              const Transform<amiss::World, Object>& pose) {
  std::vector<Segment2> cuts = slice(body, pose, impl_->height_m);
  if (cuts.empty()) {
    impl_->moving.erase(number);
  } else {
    impl_->moving[number] = std::move(cuts);
  }
}

void LaserScanner::remove_moving(std::size_t number) { impl_->moving.erase(number); }

LaserScan LaserScanner::measure(Stamp stamp, const Pose2<amiss::World, Laser>& T_world_laser) const {
  const LaserParams& params = impl_->params;
  const Eigen::Rotation2Dd turn(T_world_laser.yaw_rad);
  const Eigen::Vector2d origin = T_world_laser.position();
  std::vector<double> ranges;
  ranges.reserve(impl_->directions.size());
  for (const Eigen::Vector2d& direction : impl_->directions) {
    ranges.push_back(impl_->fixed.cast(origin, turn * direction, params.max_range_m));
  }
  for (const auto& [number, segments] : impl_->moving) {
    for (const Segment2& s : segments) {
      impl_->shade({turn.inverse() * (s.a - origin), turn.inverse() * (s.b - origin)}, ranges);
    }
  }
  LaserScan scan{stamp, -params.half_angle_rad, impl_->angle_step_rad(), params.min_range_m, params.max_range_m, {}};
  scan.ranges_m.reserve(ranges.size());
  for (const double range : ranges) {
    const bool measured = range >= params.min_range_m && range <= params.max_range_m;
    scan.ranges_m.push_back(measured ? static_cast<float>(range) : std::numeric_limits<float>::quiet_NaN());
  }
  return scan;
}

LaserScan LaserScanner::measure(Stamp stamp, const Pose2<amiss::World, Laser>& T_world_laser,
                                RandomStream& noise) const {
  LaserScan scan = measure(stamp, T_world_laser);
  for (float& range : scan.ranges_m) {
    const double measured = static_cast<double>(range) + impl_->params.sigma_m * noise.normal();
    const bool inside = measured >= scan.min_range_m && measured <= scan.max_range_m;
    range = inside ? static_cast<float>(measured) : std::numeric_limits<float>::quiet_NaN();
  }
  return scan;
}

}  // namespace amiss::sim
