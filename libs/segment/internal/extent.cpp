#include "segment/internal/extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace amiss::segment::internal {

namespace {

constexpr std::size_t kMaxPoints = 2000;
constexpr double kTrim = 0.005;  // of the points at each end
constexpr int kAngles = 30;      // of the rectangle, over 90 degrees

struct Range {
  double low = 0.0, high = 0.0;
};

/// Without the trimmed ends.
Range range_of(std::vector<double>& values) {
  const auto cut = static_cast<std::ptrdiff_t>(kTrim * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + cut, values.end());
  const double low = values[static_cast<std::size_t>(cut)];
  std::nth_element(values.begin(), values.end() - 1 - cut, values.end());
  return {low, *(values.end() - 1 - cut)};
}

struct Rectangle {
  double angle_rad = 0.0;
  Range along, across;
  [[nodiscard]] double area() const { return (along.high - along.low) * (across.high - across.low); }
};

Rectangle rectangle_at(const std::vector<Eigen::Vector2d>& points, double angle_rad) {
  const Eigen::Vector2d axis(std::cos(angle_rad), std::sin(angle_rad)), normal(-axis.y(), axis.x());
  std::vector<double> along, across;
  along.reserve(points.size());
  across.reserve(points.size());
  for (const Eigen::Vector2d& p : points) {
    along.push_back(axis.dot(p));
    across.push_back(normal.dot(p));
  }
  return {angle_rad, range_of(along), range_of(across)};
}

}  // namespace

Extent extent_of(const std::vector<Eigen::Vector3f>& points_map, const Plane& ground) {
  const std::size_t step = points_map.size() / kMaxPoints + 1;
  std::vector<Eigen::Vector2d> footprint;
  std::vector<double> heights;
  for (std::size_t i = 0; i < points_map.size(); i += step) {
    const Eigen::Vector3d p = points_map[i].cast<double>();
    footprint.emplace_back(p.head<2>());
    heights.push_back(ground.normal_map.dot(p) + ground.d_m);
  }
  Rectangle best;
  double best_area = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kAngles; ++k) {
    const Rectangle rectangle = rectangle_at(footprint, radians(90.0 * k / kAngles));
    if (rectangle.area() >= best_area) continue;
    best_area = rectangle.area();
    best = rectangle;
  }
  const Eigen::Vector2d axis(std::cos(best.angle_rad), std::sin(best.angle_rad)), normal(-axis.y(), axis.x());
  const Eigen::Vector2d middle =
      axis * (best.along.low + best.along.high) / 2.0 + normal * (best.across.low + best.across.high) / 2.0;
  const double length = best.along.high - best.along.low, width = best.across.high - best.across.low;
  const double height = std::max(0.0, range_of(heights).high);
  // The ground under the middle.
  const double z_ground = -(ground.d_m + ground.normal_map.head<2>().dot(middle)) / ground.normal_map.z();
  Extent extent;
  extent.centre_map << middle, z_ground + height / 2.0;
  extent.size_m = {std::max(length, width), std::min(length, width), height};
  const double yaw_rad = length >= width ? best.angle_rad : best.angle_rad + radians(90.0);
  extent.yaw_rad = yaw_rad > radians(90.0) ? yaw_rad - radians(180.0) : yaw_rad;
  return extent;
}

}  // namespace amiss::segment::internal
