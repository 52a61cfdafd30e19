#include "localize/internal/distance_field.hpp"

#include <algorithm>

#include "localize/internal/scan_search.hpp"

namespace amiss::localize::internal {

namespace {

constexpr int kIterations = 12;
constexpr double kFirstKernelM = 0.1;  // width of the robust weight, narrowing with each iteration
constexpr double kNewThing = 0.5;      // plausibility of a point in free space, against 1 near a wall
constexpr double kPointSigmaM = 0.1;   // of one point; wide, because neighbours share the errors of the map

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

double robust_cost(double distance_m, double kernel_m) {
  const double ratio = distance_m / kernel_m;
  return 0.5 * distance_m * distance_m / (1.0 + ratio * ratio) / (kPointSigmaM * kPointSigmaM);
}

DistanceField::DistanceField(const FloorGrid& map)
    : map_(map),
      distance_m_(distance_to_occupied_m(map, false)),
      cell_costs_(distance_m_.size()) {
  std::transform(distance_m_.begin(), distance_m_.end(), cell_costs_.begin(),
                 [](float d) { return static_cast<float>(robust_cost(static_cast<double>(d), kLastKernelM)); });
}

DistanceField::Sample DistanceField::at(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d cell = (p_map - map_.origin_m()) / map_.resolution_m() - Eigen::Vector2d::Constant(0.5);
  const double x0 = std::floor(cell.x()), y0 = std::floor(cell.y());
  if (!(x0 >= 0.0 && y0 >= 0.0 && x0 + 1.0 < map_.width() && y0 + 1.0 < map_.height())) return {kFar, {0.0, 0.0}};
  const double fx = cell.x() - x0, fy = cell.y() - y0;
  const std::size_t i = map_.index(Cell{static_cast<int>(x0), static_cast<int>(y0)});
  const std::size_t up = i + static_cast<std::size_t>(map_.width());
  const auto d00 = static_cast<double>(distance_m_[i]), d10 = static_cast<double>(distance_m_[i + 1]);
  const auto d01 = static_cast<double>(distance_m_[up]), d11 = static_cast<double>(distance_m_[up + 1]);
  const double low = d00 + fx * (d10 - d00), high = d01 + fx * (d11 - d01);
  const double slope_x = (1.0 - fy) * (d10 - d00) + fy * (d11 - d01);
  return {low + fy * (high - low), Eigen::Vector2d(slope_x, high - low) / map_.resolution_m()};
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

double plausibility_of(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
                       const Eigen::Vector2d& laser_base, const Pose2<Map, Base>& T_map_base, double near_m) {
  if (points_base.empty()) return 0.0;
  const Eigen::Rotation2Dd R(T_map_base.yaw_rad);
  const Eigen::Vector2d laser_map = R * laser_base + T_map_base.position();
  double sum = 0.0;
  for (const Eigen::Vector2d& p_base : points_base) {
    const Eigen::Vector2d p_map = R * p_base + T_map_base.position();
    if (field.at(p_map).distance_m <= near_m) {
      sum += 1.0;
    } else if (line_of_sight(field.map(), laser_map, p_map)) {
      sum += kNewThing;
    }
  }
  return sum / static_cast<double>(points_base.size());
}

Pose2<Map, Base> moved(const Pose2<Map, Base>& pose, const Eigen::Vector3d& offset) {
  return {pose.x_m + offset.x(), pose.y_m + offset.y(), wrap_angle(pose.yaw_rad + offset.z())};
}

Eigen::Vector3d offset_of(const Pose2<Map, Base>& pose, const Pose2<Map, Base>& from) {
  return {pose.x_m - from.x_m, pose.y_m - from.y_m, wrap_angle(pose.yaw_rad - from.yaw_rad)};
}

double prior_cost(const AlignmentPrior& prior, const Eigen::Vector3d& offset) {
  return 0.5 * offset.head<2>().squaredNorm() / (prior.sigma_xy_m * prior.sigma_xy_m) +
         0.5 * offset.z() * offset.z() / (prior.sigma_yaw_rad * prior.sigma_yaw_rad);
}

namespace {

Pose2<Map, Base> descended(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
                           const AlignmentPrior& prior, const Pose2<Map, Base>& start) {
  const Eigen::Vector3d information(1.0 / (prior.sigma_xy_m * prior.sigma_xy_m),
                                    1.0 / (prior.sigma_xy_m * prior.sigma_xy_m),
                                    1.0 / (prior.sigma_yaw_rad * prior.sigma_yaw_rad));
  Pose2<Map, Base> pose = start;
  for (int i = 0; i < kIterations; ++i) {
    const double kernel_m = std::max(kLastKernelM, kFirstKernelM * std::pow(0.7, i));
    Normal normal = normal_equations(field, points_base, pose, kernel_m);
    normal.H += information.asDiagonal();
    normal.b -= information.cwiseProduct(offset_of(pose, prior.T_map_base));
    const Eigen::Vector3d step = normal.H.ldlt().solve(normal.b);
    pose = moved(pose, step);
    if (kernel_m == kLastKernelM && step.head<2>().norm() < 1e-4 && std::abs(step.z()) < 1e-4) break;
  }
  return pose;
}

/// What the last steps make small.
double cost_of(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base, const AlignmentPrior& prior,
               const Pose2<Map, Base>& pose) {
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
  double sum = prior_cost(prior, offset_of(pose, prior.T_map_base));
  for (const Eigen::Vector2d& p_base : points_base) {
    sum += robust_cost(field.at(R * p_base + pose.position()).distance_m, kLastKernelM);
  }
  return sum;
}

}  // namespace

Pose2<Map, Base> aligned(const DistanceField& field, const std::vector<Eigen::Vector2d>& points_base,
                         const AlignmentPrior& prior) {
  const auto starts = best_in_window(field, points_base, prior);
  Pose2<Map, Base> best = descended(field, points_base, prior, starts.front());
  for (std::size_t i = 1; i < starts.size(); ++i) {
    const Pose2<Map, Base> other = descended(field, points_base, prior, starts[i]);
    if (cost_of(field, points_base, prior, other) < cost_of(field, points_base, prior, best)) best = other;
  }
  return best;
}

}  // namespace amiss::localize::internal
