#include "change/internal/recoloured.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::change::internal {

namespace {

constexpr float kLight = 1.6F;    // by which shadows, lamps and exposures change a colour
constexpr float kFacesUp = 0.7F;  // of the normal
constexpr float kLevelM = 0.05F;  // what is higher or lower by more is not beside it

/// Squared distance of a colour from the nearest that another has in more or in less light.
float squared_distance(const Eigen::Vector3f& colour, const Eigen::Vector3f& other) {
  const float best = colour.dot(other) / std::max(1.0F, other.squaredNorm());
  return (colour - std::clamp(best, 1.0F / kLight, kLight) * other).squaredNorm();
}

}  // namespace

segment::Indices recoloured(const RoomPair& pair, const NovelParams& params) {
  segment::Indices points;
  const ThinnedScene& before = pair.reference;
  if (before.colours.empty() || pair.current.colours.empty()) return points;
  const auto d = static_cast<float>(params.difference_m), reach = static_cast<float>(params.recolour_reach_m);
  const auto limit = static_cast<float>(params.recolour * params.recolour);
  for (std::uint32_t i = 0; i < pair.placed.size(); ++i) {
    const Eigen::Vector3f& p = pair.placed[i];
    if (pair.current.normals[i].z() < kFacesUp || !before.grid.any_within(p, d)) continue;
    const auto alike = [&](std::uint32_t j) {
      return squared_distance(pair.current.colours[i], before.colours[j]) < limit &&
             std::abs(before.points[j].z() - p.z()) <= kLevelM;
    };
    if (!before.grid.nearest_of(p, reach, alike)) points.push_back(i);
  }
  return points;
}

}  // namespace amiss::change::internal
