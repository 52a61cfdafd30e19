#include "segment/internal/ground.hpp"

#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

#include <algorithm>

namespace amiss::segment::internal {

namespace {

constexpr std::size_t kMaxPoints = 4000;
constexpr int kMinInliers = 60;
constexpr int kIterations = 150;

/// Points that the prior allows, at most kMaxPoints, evenly taken.
pcl::PointCloud<pcl::PointXYZ>::Ptr candidates_of(const Window& window, const Params& params) {
  std::vector<std::size_t> near;
  const auto limit = static_cast<float>(params.plane_offset_m);
  for (std::size_t i = 0; i < window.where.size(); ++i) {
    if (window.where[i] == Where::kInside && std::abs(window.smooth[i].z()) <= limit) near.push_back(i);
  }
  const std::size_t step = near.size() / kMaxPoints + 1;
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (std::size_t k = 0; k < near.size(); k += step) {
    const Eigen::Vector3f& p = window.smooth[near[k]];
    cloud->emplace_back(p.x(), p.y(), p.z());
  }
  return cloud;
}

}  // namespace

std::optional<Plane> ground_of(const Window& window, const Params& params) {
  const auto cloud = candidates_of(window, params);
  if (cloud->size() < static_cast<std::size_t>(kMinInliers)) return std::nullopt;
  // The model's generator has a fixed seed unless `random` is set.
  const auto model = std::make_shared<pcl::SampleConsensusModelPerpendicularPlane<pcl::PointXYZ>>(cloud, false);
  model->setAxis(Eigen::Vector3f::UnitZ());
  model->setEpsAngle(params.plane_tilt_rad);
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, params.plane_distance_m);
  ransac.setMaxIterations(kIterations);
  if (!ransac.computeModel()) return std::nullopt;
  pcl::Indices inliers;
  Eigen::VectorXf coefficients, fitted;
  ransac.getInliers(inliers);
  ransac.getModelCoefficients(coefficients);
  if (inliers.size() < static_cast<std::size_t>(kMinInliers)) return std::nullopt;
  model->optimizeModelCoefficients(inliers, coefficients, fitted);
  if (fitted.size() != 4 || !fitted.allFinite()) fitted = coefficients;
  if (fitted[2] < 0.0F) fitted = -fitted;
  if (static_cast<double>(fitted[2]) < std::cos(params.plane_tilt_rad)) return std::nullopt;
  return Plane{fitted.head<3>().cast<double>(), static_cast<double>(fitted[3]), static_cast<int>(inliers.size())};
}

}  // namespace amiss::segment::internal
