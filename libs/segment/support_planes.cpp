#include "segment/support_planes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace amiss::segment {

namespace {

constexpr int kTrials = 60;
constexpr std::size_t kScored = 800;  // points that judge a trial, evenly taken
constexpr int kRefits = 3;
constexpr float kCellM = 0.02F;

struct Height {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double d = 0.0;
  [[nodiscard]] double operator()(const Eigen::Vector3f& p) const { return normal.dot(p.cast<double>()) + d; }
};

std::optional<Height> through(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                              double min_up) {
  Eigen::Vector3d normal = (b - a).cross(c - a);
  if (normal.norm() < 1e-9) return std::nullopt;
  normal.normalize();
  if (normal.z() < 0.0) normal = -normal;
  if (normal.z() < min_up) return std::nullopt;
  return Height{normal, -normal.dot(a)};
}

/// Least squares over the points; the plane before where they are too few or too steep.
Height fitted(const std::vector<Eigen::Vector3f>& points, const Indices& inliers, const Height& before, double min_up) {
  if (inliers.size() < 3) return before;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : inliers) mean += points[i].cast<double>();
  mean /= static_cast<double>(inliers.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : inliers) {
    const Eigen::Vector3d d = points[i].cast<double>() - mean;
    scatter += d * d.transpose();
  }
  Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
  if (normal.z() < 0.0) normal = -normal;
  if (normal.z() < min_up) return before;
  return {normal, -normal.dot(mean)};
}

Indices inliers_of(const std::vector<Eigen::Vector3f>& points, const Indices& among, const Height& plane,
                   double distance_m) {
  Indices inliers;
  for (const std::uint32_t i : among) {
    if (std::abs(plane(points[i])) <= distance_m) inliers.push_back(i);
  }
  return inliers;
}

/// The plane of most inliers among some trials: through three points, or level through one of them.
Height best_trial(const std::vector<Eigen::Vector3f>& points, const Indices& among, const SupportPlaneParams& params,
                  RandomStream& random) {
  Indices judges;
  const std::size_t step = among.size() / kScored + 1;
  for (std::size_t k = 0; k < among.size(); k += step) judges.push_back(among[k]);
  const double min_up = std::cos(params.max_tilt_rad);
  const auto draw = [&] { return points[among[random.below(among.size())]].cast<double>().eval(); };
  Height best;
  std::size_t most = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector3d a = draw(), b = draw(), c = draw();
    const Height plane = through(a, b, c, min_up).value_or(Height{Eigen::Vector3d::UnitZ(), -a.z()});
    const std::size_t n = inliers_of(points, judges, plane, params.distance_m).size();
    if (n > most) {
      most = n;
      best = plane;
    }
  }
  return best;
}

SupportPlane plane_in(const std::vector<Eigen::Vector3f>& points, const Indices& among,
                      const SupportPlaneParams& params, RandomStream& random) {
  Height plane = best_trial(points, among, params, random);
  SupportPlane out;
  out.inliers = inliers_of(points, among, plane, params.distance_m);
  for (int k = 0; k < kRefits; ++k) {
    plane = fitted(points, out.inliers, plane, std::cos(params.max_tilt_rad));
    out.inliers = inliers_of(points, among, plane, params.distance_m);
  }
  out.plane = {plane.normal, plane.d, static_cast<int>(out.inliers.size())};
  out.footprint = Footprint(points, out.inliers, kCellM);
  out.area_m2 = out.footprint.area_m2();
  double z = 0.0;
  for (const std::uint32_t i : out.inliers) z += static_cast<double>(points[i].z());
  out.height_m = z / static_cast<double>(std::max<std::size_t>(1, out.inliers.size()));
  return out;
}

constexpr double kMeanNormalTilts = 2.0;  // of a plane's largest tilt: so far may its points' normals lean together

/// Do the normals of its points, taken together, stand as a plane's do? A strip cut from a ramp has points enough, but
/// leans.
bool is_level(const std::vector<Eigen::Vector3f>& normals, const Indices& inliers, const SupportPlaneParams& params) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : inliers) sum += normals[i].cast<double>();
  return sum.z() >= std::cos(kMeanNormalTilts * params.max_tilt_rad) * sum.norm();
}

Indices level_points(const std::vector<Eigen::Vector3f>& normals, const std::vector<SemanticClass>& labels,
                     const SupportPlaneParams& params) {
  const auto min_up = static_cast<float>(std::cos(params.max_normal_tilt_rad));
  Indices level;
  for (std::uint32_t i = 0; i < normals.size(); ++i) {
    if (normals[i].z() >= min_up && (labels.empty() || may_support(labels[i]))) level.push_back(i);
  }
  return level;
}

}  // namespace

std::vector<SupportPlane> support_planes(const std::vector<Eigen::Vector3f>& points,
                                         const std::vector<Eigen::Vector3f>& normals,
                                         const std::vector<SemanticClass>& labels, const SupportPlaneParams& params,
                                         RandomStream random) {
  const double cell_m2 = static_cast<double>(kCellM) * static_cast<double>(kCellM);
  const auto min_points = static_cast<std::size_t>(std::max(3.0, params.min_area_m2 / cell_m2));
  std::vector<SupportPlane> planes;
  for (Indices left : euclidean_clusters(points, level_points(normals, labels, params),
                                         static_cast<float>(params.cluster_distance_m), min_points)) {
    while (left.size() >= min_points) {
      SupportPlane found = plane_in(points, left, params, random);
      if (found.area_m2 < params.min_area_m2) break;
      Indices rest;
      std::set_difference(left.begin(), left.end(), found.inliers.begin(), found.inliers.end(),
                          std::back_inserter(rest));
      left = std::move(rest);
      if (is_level(normals, found.inliers, params)) planes.push_back(std::move(found));
    }
  }
  std::stable_sort(planes.begin(), planes.end(),
                   [](const SupportPlane& a, const SupportPlane& b) { return a.height_m < b.height_m; });
  return planes;
}

}  // namespace amiss::segment
