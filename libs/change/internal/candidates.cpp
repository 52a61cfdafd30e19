#include "change/internal/candidates.hpp"

#include <limits>

namespace amiss::change::internal {

namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

/// Height of the highest surface under p, or -infinity.
double surface_under(const std::vector<Support>& supports, const Eigen::Vector3f& p, double min_above_m) {
  double height = kNone;
  for (const Support& s : supports) {
    const double above = s.plane.above(p);
    if (above <= min_above_m || !s.ground.contains(p.x(), p.y())) continue;
    height = std::max(height, static_cast<double>(p.z()) - above);
  }
  return height;
}

bool is_prop(const ThinnedScene& scene, std::uint32_t i) {
  return !scene.labels.empty() && scene.labels[i] == SemanticClass::kOtherProp;
}

}  // namespace

std::vector<Candidate> candidates_of(const ThinnedScene& current, const std::vector<Support>& supports, From from,
                                     Surfaces surfaces, const NovelParams& params) {
  segment::Indices among;
  std::vector<double> heights(current.points.size(), kNone);
  for (std::uint32_t i = 0; i < current.points.size(); ++i) {
    const bool prop = is_prop(current, i);
    if (current.on_plane[i] && !(prop && surfaces == Surfaces::kKept)) continue;
    heights[i] = surface_under(supports, current.points[i], params.planes.distance_m);
    const bool stands = from == From::kPlanesAndLabels && heights[i] != kNone;
    if (stands || prop) among.push_back(i);
  }
  std::vector<Candidate> candidates;
  for (segment::Indices& cluster :
       segment::euclidean_clusters(current.points, among, static_cast<float>(params.cluster_distance_m),
                                   static_cast<std::size_t>(params.min_points))) {
    std::size_t props = 0;
    double highest = kNone;
    for (const std::uint32_t i : cluster) {
      props += is_prop(current, i) ? 1U : 0U;
      highest = std::max(highest, heights[i]);
    }
    const bool labelled = from == From::kLabels || 2 * props > cluster.size();
    candidates.push_back({std::move(cluster), labelled ? "otherprop" : "plane", highest == kNone ? 0.0 : highest});
  }
  return candidates;
}

}  // namespace amiss::change::internal
