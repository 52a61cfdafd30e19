#include "localize/internal/distance_field.hpp"

#include <algorithm>

namespace amiss::localize::internal {

namespace {

constexpr int kIterations = 12;
constexpr double kFirstKernelM = 0.2;  // width of the robust weight, narrowing with each iteration
constexpr double kLastKernelM = 0.06;
constexpr double kPointSigmaM = 0.1;  // of one point; wide, because neighbours share the errors of the map

struct Normal {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

Normal normal_equations(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
                        const Pose2<Map, Base>& pose, double kernel_m) {
  const double c = std::cos(pose.yaw_rad), s = std::sin(pose.yaw_rad);
  Normal sum;
  for (const Eigen::Vector2d& p : points_base) {
    const Eigen::Vector2d turned(c * p.x() - s * p.y(), s * p.x() + c * p.y());
    const DistanceField::Sample sample = field.at(pose.position() + turned);
    const double ratio = sample.distance_m / kernel_m;
    const double root = 1.0 / (1.0 + ratio * ratio);
    const double weight = root * root / (kPointSigmaM * kPointSigmaM);
    const Eigen::Vector3d J(sample.gradient.x(), sample.gradient.y(),
                            sample.gradient.y() * turned.x() - sample.gradient.x() * turned.y());
    sum.H += weight * J * J.transpose();
    sum.b -= weight * sample.distance_m * J;
  }
  return sum;
}

}  // namespace

DistanceField::DistanceField(const FloorGrid& map)
    : frame_(map.resolution_m(), map.origin_m(), map.width(), map.height()),
      distance_m_(distance_to_occupied_m(map, false)) {}

DistanceField::Sample DistanceField::at(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d cell = (p_map - frame_.origin_m()) / frame_.resolution_m() - Eigen::Vector2d::Constant(0.5);
  const double x0 = std::floor(cell.x()), y0 = std::floor(cell.y());
  if (!(x0 >= 0.0 && y0 >= 0.0 && x0 + 1.0 < frame_.width() && y0 + 1.0 < frame_.height())) return {kFar, {0.0, 0.0}};
  const double fx = cell.x() - x0, fy = cell.y() - y0;
  const std::size_t i = frame_.index(Cell{static_cast<int>(x0), static_cast<int>(y0)});
  const std::size_t up = i + static_cast<std::size_t>(frame_.width());
  const auto d00 = static_cast<double>(distance_m_[i]), d10 = static_cast<double>(distance_m_[i + 1]);
  const auto d01 = static_cast<double>(distance_m_[up]), d11 = static_cast<double>(distance_m_[up + 1]);
  const double low = d00 + fx * (d10 - d00), high = d01 + fx * (d11 - d01);
  const double slope_x = (1.0 - fy) * (d10 - d00) + fy * (d11 - d01);
  return {low + fy * (high - low), Eigen::Vector2d(slope_x, high - low) / frame_.resolution_m()};
}

std::vector<Eigen::Vector2d> points_of(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser,
                                       int max_points) {
  const auto wanted = static_cast<std::size_t>(std::max(1, max_points));
  const std::size_t step = std::max<std::size_t>(1, (scan.ranges_m.size() + wanted - 1) / wanted);
  std::vector<Eigen::Vector2d> points_base;
  points_base.reserve(wanted);
  for (std::size_t i = 0; i < scan.ranges_m.size(); i += step) {
    const auto range_m = static_cast<double>(scan.ranges_m[i]);
    if (!std::isfinite(range_m) || range_m < scan.min_range_m || range_m > scan.max_range_m) continue;
    const double angle_rad = scan.angle_min_rad + static_cast<double>(i) * scan.angle_step_rad;
    const Eigen::Vector3d p_laser(range_m * std::cos(angle_rad), range_m * std::sin(angle_rad), 0.0);
    points_base.emplace_back((T_base_laser.T * p_laser).head<2>());
  }
  return points_base;
}

double fit_of(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
              const Pose2<Map, Base>& T_map_base, double near_m) {
  if (points_base.empty()) return 0.0;
  const Eigen::Rotation2Dd R(T_map_base.yaw_rad);
  const auto near = std::count_if(points_base.begin(), points_base.end(), [&](const Eigen::Vector2d& p_base) {
    return field.at(R * p_base + T_map_base.position()).distance_m <= near_m;
  });
  return static_cast<double>(near) / static_cast<double>(points_base.size());
}

Pose2<Map, Base> aligned(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
                         const AlignmentPrior& prior) {
  const Eigen::Vector3d information(1.0 / (prior.sigma_xy_m * prior.sigma_xy_m),
                                    1.0 / (prior.sigma_xy_m * prior.sigma_xy_m),
                                    1.0 / (prior.sigma_yaw_rad * prior.sigma_yaw_rad));
  Pose2<Map, Base> pose = prior.T_map_base;
  for (int i = 0; i < kIterations; ++i) {
    const double kernel_m = std::max(kLastKernelM, kFirstKernelM * std::pow(0.7, i));
    const Eigen::Vector3d from_prior(pose.x_m - prior.T_map_base.x_m, pose.y_m - prior.T_map_base.y_m,
                                     wrap_angle(pose.yaw_rad - prior.T_map_base.yaw_rad));
    Normal normal = normal_equations(field, points_base, pose, kernel_m);
    normal.H += information.asDiagonal();
    normal.b -= information.cwiseProduct(from_prior);
    const Eigen::Vector3d step = normal.H.ldlt().solve(normal.b);
    pose = {pose.x_m + step.x(), pose.y_m + step.y(), wrap_angle(pose.yaw_rad + step.z())};
    if (kernel_m == kLastKernelM && step.head<2>().norm() < 1e-4 && std::abs(step.z()) < 1e-4) break;
  }
  return pose;
}

}  // namespace amiss::localize::internal
