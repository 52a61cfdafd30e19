#include "localize/internal/line_map.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "localize/internal/mrpt_types.hpp"

namespace amiss::localize::internal {

namespace {

constexpr std::size_t kReach = 4;        // beams to each side that make a line
constexpr double kMaxStepM = 0.12;       // between two points of one line
constexpr double kMaxResidualM = 0.015;  // root mean square of the points about their line
constexpr double kMinNormalDot = 0.8;
constexpr int kIterations = 12;
constexpr double kFirstRadiusM = 0.12, kLastRadiusM = 0.05;  // of correspondences
constexpr double kKernelM = 0.03;                            // width of the robust weight
constexpr double kPointSigmaM = 0.03;                        // of one correspondence; neighbours share errors
constexpr double kPriorSigmaM = 0.05, kPriorSigmaRad = radians(2.0);

std::int64_t key_of(std::int64_t x, std::int64_t y) { return (x << 32) ^ (y & 0xFFFFFFFF); }
std::int64_t square_of(double coordinate) { return std::llround(std::floor(coordinate / LineMap::kEdgeM)); }

LinePoint moved(const LinePoint& point_base, const Pose2<Map, Base>& T_map_base) {
  const Eigen::Rotation2Dd R(T_map_base.yaw_rad);
  return {R * point_base.p + T_map_base.position(), R * point_base.n};
}

/// The line through p[first .. last], at the foot of p[at]; none where they do not lie on one.
std::optional<LinePoint> line_through(const std::vector<Eigen::Vector2d>& p, std::size_t first, std::size_t last,
                                      std::size_t at, const Eigen::Vector2d& laser) {
  const auto n = static_cast<double>(last - first + 1);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = first; i <= last; ++i) mean += p[i] / n;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t i = first; i <= last; ++i) spread += (p[i] - mean) * (p[i] - mean).transpose() / n;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(spread);
  const double thin = std::sqrt(std::max(0.0, eigen.eigenvalues()[0]));
  if (thin > kMaxResidualM || eigen.eigenvalues()[1] < 4.0 * eigen.eigenvalues()[0]) return std::nullopt;
  Eigen::Vector2d normal = eigen.eigenvectors().col(0);
  if (normal.dot(laser - mean) < 0.0) normal = -normal;
  return LinePoint{p[at] - normal * normal.dot(p[at] - mean), normal};
}

struct Sums {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double weight = 0.0;
};

Sums sums_at(const LineMap& map, const std::vector<LinePoint>& points_base, const Pose2<Map, Base>& pose,
             double radius_m) {
  Sums sums;
  for (const LinePoint& point_base : points_base) {
    const LinePoint point = moved(point_base, pose);
    const auto match = map.nearest(point, radius_m);
    if (!match) continue;
    const double r = match->n.dot(point.p - match->p);
    const double root = 1.0 / (1.0 + r * r / (kKernelM * kKernelM));
    const double weight = root * root / (kPointSigmaM * kPointSigmaM);
    const Eigen::Vector2d arm = point.p - pose.position();
    const Eigen::Vector3d J(match->n.x(), match->n.y(), match->n.y() * arm.x() - match->n.x() * arm.y());
    sums.H += weight * J * J.transpose();
    sums.b -= weight * r * J;
    sums.weight += root * root;
  }
  return sums;
}

}  // namespace

std::vector<LinePoint> line_points_of(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser) {
  std::vector<Eigen::Vector2d> p;
  p.reserve(scan.ranges_m.size());
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    if (!valid_range(scan, i)) continue;
    const double angle_rad = scan.angle_min_rad + static_cast<double>(i) * scan.angle_step_rad;
    const Eigen::Vector3d dir(std::cos(angle_rad), std::sin(angle_rad), 0.0);
    p.emplace_back((T_base_laser.T * (static_cast<double>(scan.ranges_m[i]) * dir)).head<2>());
  }
  const Eigen::Vector2d laser = T_base_laser.T.translation().head<2>();
  std::vector<LinePoint> points_base;
  points_base.reserve(p.size());
  for (std::size_t at = 0; at < p.size(); ++at) {
    std::size_t first = at, last = at;
    while (first > 0 && at - first < kReach && (p[first] - p[first - 1]).norm() < kMaxStepM) --first;
    while (last + 1 < p.size() && last - at < kReach && (p[last] - p[last + 1]).norm() < kMaxStepM) ++last;
    if (last - first < kReach) continue;
    if (const auto point = line_through(p, first, last, at, laser)) points_base.push_back(*point);
  }
  return points_base;
}

void LineMap::add(const std::vector<LinePoint>& points_base, const Pose2<Map, Base>& T_map_base, double spacing_m) {
  for (const LinePoint& point_base : points_base) {
    const LinePoint point = moved(point_base, T_map_base);
    if (nearest(point, spacing_m)) continue;
    squares_[key_of(square_of(point.p.x()), square_of(point.p.y()))].push_back(point);
    ++size_;
  }
}

double LineMap::new_part(const std::vector<LinePoint>& points_base, const Pose2<Map, Base>& T_map_base,
                         double spacing_m) const {
  if (points_base.empty()) return 1.0;
  const auto added = std::count_if(points_base.begin(), points_base.end(), [&](const LinePoint& point_base) {
    return !nearest(moved(point_base, T_map_base), spacing_m);
  });
  return static_cast<double>(added) / static_cast<double>(points_base.size());
}

std::optional<LinePoint> LineMap::nearest(const LinePoint& to, double radius_m) const {
  const std::int64_t x = square_of(to.p.x()), y = square_of(to.p.y());
  std::optional<LinePoint> best;
  double best_m2 = radius_m * radius_m;
  for (std::int64_t i = 0; i < 9; ++i) {
    const auto square = squares_.find(key_of(x + i % 3 - 1, y + i / 3 - 1));
    if (square == squares_.end()) continue;
    for (const LinePoint& point : square->second) {
      const double distance_m2 = (point.p - to.p).squaredNorm();
      if (distance_m2 >= best_m2 || point.n.dot(to.n) < kMinNormalDot) continue;
      best_m2 = distance_m2;
      best = point;
    }
  }
  return best;
}

LineAlignment LineMap::aligned(const std::vector<LinePoint>& points_base, const Pose2<Map, Base>& guess) const {
  const double per_m2 = 1.0 / (kPriorSigmaM * kPriorSigmaM);
  const Eigen::Vector3d information(per_m2, per_m2, 1.0 / (kPriorSigmaRad * kPriorSigmaRad));
  LineAlignment out{guess, Eigen::Matrix3d::Zero(), 0.0};
  for (int i = 0; i < kIterations; ++i) {
    const double radius_m = std::max(kLastRadiusM, kFirstRadiusM * std::pow(0.75, i));
    const Pose2<Map, Base>& pose = out.T_map_base;
    Sums sums = sums_at(*this, points_base, pose, radius_m);
    const Eigen::Vector3d off(pose.x_m - guess.x_m, pose.y_m - guess.y_m, wrap_angle(pose.yaw_rad - guess.yaw_rad));
    sums.H += information.asDiagonal();
    sums.b -= information.cwiseProduct(off);
    const auto solver = sums.H.ldlt();
    const Eigen::Vector3d step = solver.solve(sums.b);
    out.T_map_base = {pose.x_m + step.x(), pose.y_m + step.y(), wrap_angle(pose.yaw_rad + step.z())};
    out.covariance = solver.solve(Eigen::Matrix3d::Identity());
    out.matched_part = points_base.empty() ? 0.0 : sums.weight / static_cast<double>(points_base.size());
    if (radius_m == kLastRadiusM && step.head<2>().norm() < 1e-4 && std::abs(step.z()) < 5e-5) break;
  }
  return out;
}

}  // namespace amiss::localize::internal
