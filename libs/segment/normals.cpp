#include "segment/normals.hpp"

#include <Eigen/Eigenvalues>

namespace amiss::segment {

namespace {

constexpr int kMinNeighbours = 5;
constexpr float kMinSecondAxis = 0.02F;  // share of the second of the largest eigenvalue: less is a line

Eigen::Vector3f normal_at(const std::vector<Eigen::Vector3f>& points, const PointGrid& grid, float radius_m,
                          const Eigen::Vector3f& place) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
  int n = 0;
  grid.for_each_within(place, radius_m, [&](std::uint32_t i, float) {
    const Eigen::Vector3f d = points[i] - place;
    sum += d;
    squares += d * d.transpose();
    ++n;
  });
  if (n < kMinNeighbours) return Eigen::Vector3f::Zero();
  const auto count = static_cast<float>(n);
  const Eigen::Matrix3f covariance = squares / count - (sum / count) * (sum / count).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
  axes.computeDirect(covariance);
  if (axes.eigenvalues()[1] < kMinSecondAxis * axes.eigenvalues()[2]) return Eigen::Vector3f::Zero();
  const Eigen::Vector3f normal = axes.eigenvectors().col(0).normalized();
  return normal.z() < 0.0F ? Eigen::Vector3f(-normal) : normal;
}

}  // namespace

std::vector<Eigen::Vector3f> upward_normals(const std::vector<Eigen::Vector3f>& points, const PointGrid& grid,
                                            float radius_m) {
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(points.size());
  for (const Eigen::Vector3f& p : points) normals.push_back(normal_at(points, grid, radius_m, p));
  return normals;
}

}  // namespace amiss::segment
