#include "change/internal/candidates.hpp"

#include <limits>
#include <map>

namespace amiss::change::internal {

namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

struct Under {
  double height_m = kNone;
  std::size_t support = kNowhere;
};

/// The highest surface under p.
Under surface_under(const std::vector<Support>& supports, const Eigen::Vector3f& p, double min_above_m) {
  Under under;
  for (std::size_t s = 0; s < supports.size(); ++s) {
    const double above = supports[s].plane.above(p);
    if (above <= min_above_m || !supports[s].ground.contains(p.x(), p.y())) continue;
    const double height = static_cast<double>(p.z()) - above;
    if (height > under.height_m) under = {height, s};
  }
  return under;
}

bool is_prop(const ThinnedScene& scene, std::uint32_t i) {
  return !scene.labels.empty() && scene.labels[i] == SemanticClass::kOtherProp;
}

}  // namespace

std::vector<Candidate> candidates_of(const ThinnedScene& current, const std::vector<Support>& supports, From from,
                                     Surfaces surfaces, const NovelParams& params) {
  // What is not verified cannot come off the furniture that it touches but by the surface it stands on.
  const bool apart = from == From::kPlanesAndLabels && surfaces == Surfaces::kKept;
  std::map<std::size_t, segment::Indices> among;  // by the surface that they are above, or all in one
  std::vector<double> heights(current.points.size(), kNone);
  for (std::uint32_t i = 0; i < current.points.size(); ++i) {
    const bool prop = is_prop(current, i);
    if (current.on_plane[i] && !(prop && surfaces == Surfaces::kKept)) continue;
    const Under under = surface_under(supports, current.points[i], params.planes.distance_m);
    heights[i] = under.height_m;
    const bool stands = from == From::kPlanesAndLabels && under.support != kNowhere;
    if (stands || prop) among[apart ? under.support : kNowhere].push_back(i);
  }
  std::vector<Candidate> candidates;
  for (const auto& [support, points] : among) {
    for (segment::Indices& cluster :
         segment::euclidean_clusters(current.points, points, static_cast<float>(params.cluster_distance_m),
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
  }
  return candidates;
}

}  // namespace amiss::change::internal
