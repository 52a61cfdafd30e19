#include "change/internal/thinned_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/result.hpp"
#include "segment/normals.hpp"

namespace amiss::change::internal {

namespace {

constexpr float kNormalRadiusM = 0.03F;

void check(const Scene& scene) {
  const std::size_t n = scene.cloud.points.size();
  if (n == 0) throw ArgumentError("A cloud to compare has no points; at least one is needed.");
  const auto fits = [n](std::size_t m) { return m == 0 || m == n; };
  if (!fits(scene.cloud.colours.size()) || !fits(scene.labels.size())) {
    throw ArgumentError("A cloud to compare has " + std::to_string(n) + " points, " +
                        std::to_string(scene.cloud.colours.size()) + " colours and " +
                        std::to_string(scene.labels.size()) + " labels; there must be one for each point, or none.");
  }
  for (const Eigen::Vector3f& p : scene.cloud.points) {
    if (!p.allFinite()) throw ArgumentError("A cloud to compare has a point that is not finite; leave it out.");
  }
}

/// The indices of the points, those of one voxel side by side.
std::vector<std::uint32_t> by_voxel(const std::vector<std::array<int, 3>>& voxels) {
  std::vector<std::uint32_t> order(voxels.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return voxels[a] != voxels[b] ? voxels[a] < voxels[b] : a < b; });
  return order;
}

SemanticClass most_common(const Scene& scene, const std::vector<std::uint32_t>& order, std::size_t begin,
                          std::size_t end) {
  std::array<int, 256> votes{};
  SemanticClass best = scene.labels[order[begin]];
  for (std::size_t k = begin; k < end; ++k) {
    const SemanticClass label = scene.labels[order[k]];
    if (++votes[static_cast<std::size_t>(label)] > votes[static_cast<std::size_t>(best)]) best = label;
  }
  return best;
}

void add_voxel(ThinnedScene& out, const Scene& scene, const std::vector<std::uint32_t>& order, std::size_t begin,
               std::size_t end) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero(), colour = Eigen::Vector3d::Zero();
  for (std::size_t k = begin; k < end; ++k) {
    out.thinned_of[order[k]] = static_cast<std::uint32_t>(out.points.size());
    place += scene.cloud.points[order[k]].cast<double>();
    if (scene.cloud.colours.empty()) continue;
    const Rgb& c = scene.cloud.colours[order[k]];
    colour += Eigen::Vector3d(c.r, c.g, c.b);
  }
  const auto n = static_cast<double>(end - begin);
  out.points.emplace_back((place / n).cast<float>());
  if (!scene.cloud.colours.empty()) out.colours.emplace_back((colour / n).cast<float>());
  if (!scene.labels.empty()) out.labels.push_back(most_common(scene, order, begin, end));
}

}  // namespace

std::vector<bool> marked(std::size_t points, const std::vector<segment::SupportPlane>& planes) {
  std::vector<bool> on_plane(points, false);
  for (const segment::SupportPlane& plane : planes) {
    for (const std::uint32_t i : plane.inliers) on_plane[i] = true;
  }
  return on_plane;
}

ThinnedScene thinned(const Scene& scene, const NovelParams& params) {
  check(scene);
  ThinnedScene out;
  out.thinned_of.resize(scene.cloud.points.size());
  std::vector<std::array<int, 3>> voxels;
  voxels.reserve(scene.cloud.points.size());
  const auto index = [&](float v) { return static_cast<int>(std::floor(static_cast<double>(v) / params.voxel_m)); };
  for (const Eigen::Vector3f& p : scene.cloud.points) voxels.push_back({index(p.x()), index(p.y()), index(p.z())});
  const std::vector<std::uint32_t> order = by_voxel(voxels);
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin + 1;
    while (end < order.size() && voxels[order[end]] == voxels[order[begin]]) ++end;
    add_voxel(out, scene, order, begin, end);
    begin = end;
  }
  out.grid = segment::PointGrid(out.points, kGridEdgeM);
  out.normals = segment::upward_normals(out.points, out.grid, kNormalRadiusM);
  out.planes = segment::support_planes(out.points, out.normals, out.labels, params.planes, RandomStream(1, "planes"));
  out.on_plane = marked(out.points.size(), out.planes);
  return out;
}

}  // namespace amiss::change::internal
