// A scene as detection works on it: one point for each voxel (mean of its points), normals, support planes, and which
// points are stuff, not plane.
#pragma once

#include "change/novel.hpp"
#include "segment/point_grid.hpp"

namespace amiss::change::internal {

struct ThinnedScene {
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<Eigen::Vector3f> colours;   // or none
  std::vector<SemanticClass> labels;      // of most points of the voxel, or none
  std::vector<std::uint32_t> thinned_of;  // for each point of the scene
  std::vector<segment::SupportPlane> planes;
  std::vector<bool> on_plane;  // it is an inlier of one of `planes`
  segment::PointGrid grid{{}, 1.0F};
};

inline constexpr float kGridEdgeM = 0.02F;

[[nodiscard]] ThinnedScene thinned(const Scene& scene, const NovelParams& params);

/// Marks the inliers of the planes.
[[nodiscard]] std::vector<bool> marked(std::size_t points, const std::vector<segment::SupportPlane>& planes);

}  // namespace amiss::change::internal
