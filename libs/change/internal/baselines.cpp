#include "change/internal/baselines.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>

#include "change/region.hpp"

namespace amiss::change::internal {

namespace {

constexpr double kOctomapM = 0.05;              // res of Table 4.1
constexpr std::size_t kOctomapMinVoxels = 4;    // c_min of Table 4.1
constexpr std::size_t kMetaroomMinPoints = 40;  // small
constexpr double kPlanarM = 0.01, kPlanarShare = 0.9;

/// Lower corners of the reference's voxels, dilated in x and y.
mapping::VoxelMap dilated_voxels(const Scene& reference) {
  mapping::VoxelMapParams voxels;
  voxels.resolution_m = kOctomapM;
  mapping::VoxelMap map(voxels);
  for (const Eigen::Vector3f& p : reference.cloud.points) map.set(map.voxel_at(p.cast<double>()), Occupancy::kOccupied);
  return mapping::dilated(map);
}

bool is_of_interest(const std::vector<mapping::Voxel>& group, const RegionParams& limits) {
  if (group.size() < kOctomapMinVoxels || group.size() > static_cast<std::size_t>(limits.max_voxels)) return false;
  mapping::Voxel low = group.front(), high = low;
  for (const mapping::Voxel& v : group) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  constexpr double kSpareM = 1e-6;
  const int across = std::max(high.x - low.x, high.y - low.y) + 1;
  return (high.z - low.z + 1) * kOctomapM <= limits.max_height_m + kSpareM &&
         across * kOctomapM <= limits.max_across_m + kSpareM;
}

bool is_planar(const std::vector<Eigen::Vector3f>& points, const segment::Indices& cluster) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : cluster) mean += points[i].cast<double>();
  mean /= static_cast<double>(cluster.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : cluster) {
    const Eigen::Vector3d d = points[i].cast<double>() - mean;
    scatter += d * d.transpose();
  }
  const Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
  const auto flat = std::count_if(cluster.begin(), cluster.end(), [&](std::uint32_t i) {
    return std::abs(normal.dot(points[i].cast<double>() - mean)) <= kPlanarM;
  });
  return static_cast<double>(flat) > kPlanarShare * static_cast<double>(cluster.size());
}

}  // namespace

segment::Indices octomap_difference(const Scene& reference, const ThinnedScene& current) {
  const mapping::VoxelMap before = dilated_voxels(reference);
  std::map<mapping::Voxel, segment::Indices> appeared;
  for (std::uint32_t i = 0; i < current.points.size(); ++i) {
    const Eigen::Vector3d p = current.points[i].cast<double>();
    const bool looked = !reference.space || reference.space->at(p) != Occupancy::kUnknown;
    const mapping::Voxel v = before.voxel_at(p);
    if (looked && before.at(v) != Occupancy::kOccupied) appeared[v].push_back(i);
  }
  std::vector<mapping::Voxel> voxels;
  for (const auto& [voxel, points] : appeared) voxels.push_back(voxel);
  segment::Indices novel;
  for (const std::vector<mapping::Voxel>& group : clusters(voxels)) {
    if (!is_of_interest(group, {})) continue;
    for (const mapping::Voxel& v : group) novel.insert(novel.end(), appeared[v].begin(), appeared[v].end());
  }
  std::sort(novel.begin(), novel.end());
  return novel;
}

segment::Indices metaroom_difference(const RoomPair& pair, const NovelParams& params) {
  segment::Indices different;
  for (std::uint32_t i = 0; i < pair.current.points.size(); ++i) {
    const Eigen::Vector3f p = pair.drift.whole() * pair.current.points[i];
    if (!pair.reference.grid.any_within(p, static_cast<float>(params.difference_m))) different.push_back(i);
  }
  segment::Indices novel;
  for (const segment::Indices& cluster : segment::euclidean_clusters(
           pair.current.points, different, static_cast<float>(params.filter_distance_m), kMetaroomMinPoints)) {
    if (!is_planar(pair.current.points, cluster)) novel.insert(novel.end(), cluster.begin(), cluster.end());
  }
  std::sort(novel.begin(), novel.end());
  return novel;
}

}  // namespace amiss::change::internal
