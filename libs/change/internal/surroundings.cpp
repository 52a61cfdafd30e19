#include "change/internal/surroundings.hpp"

#include <cmath>

namespace amiss::change::internal {

namespace {

constexpr std::size_t kSamples = 150;
constexpr float kSameNormal = 0.9F;  // dot product: 25 degrees, as of points of a plane (Table 5.1)

/// Share of some of the points, evenly taken, for which `holds(index)`.
template <class Holds>
double share_of(const segment::Indices& points, Holds holds) {
  const std::size_t n = std::min(kSamples, points.size());
  std::size_t yes = 0;
  for (std::size_t k = 0; k < n; ++k) yes += holds(points[k * points.size() / n]) ? 1U : 0U;
  return static_cast<double>(yes) / static_cast<double>(n);
}

bool alike(const RoomPair& pair, std::uint32_t i, std::uint32_t j, const NovelParams& params) {
  if (pair.reference.colours.empty() || pair.current.colours.empty()) return true;
  const float distance = (pair.reference.colours[j] - pair.current.colours[i]).norm();
  return static_cast<double>(distance) <= params.max_colour_distance;
}

}  // namespace

bool continues(const RoomPair& pair, std::uint32_t i, const NovelParams& params) {
  const Eigen::Vector3f& p = pair.placed[i];
  const mapping::VoxelMap* const space = pair.reference_space;
  if (space != nullptr && space->at(p.cast<double>()) == Occupancy::kFree) return false;
  const auto offset = static_cast<float>(params.planes.distance_m);
  return pair.reference.grid
      .nearest_of(p, static_cast<float>(params.continuation_m),
                  [&](std::uint32_t j) {
                    const Eigen::Vector3f& n = pair.reference.normals[j];
                    return alike(pair, i, j, params) && std::abs(n.dot(pair.current.normals[i])) >= kSameNormal &&
                           std::abs(n.dot(p - pair.reference.points[j])) <= offset;
                  })
      .has_value();
}

bool nudged(const RoomPair& pair, std::uint32_t i, const NovelParams& params) {
  const Eigen::Vector3f& p = pair.placed[i];
  const auto level = static_cast<float>(params.planes.distance_m);
  const auto reach = static_cast<float>(std::hypot(params.nudge_m, params.planes.distance_m));
  return pair.reference.grid
      .nearest_of(p, reach,
                  [&](std::uint32_t j) {
                    const Eigen::Vector3f d = p - pair.reference.points[j];
                    return alike(pair, i, j, params) && std::abs(d.z()) <= level &&
                           static_cast<double>(d.head<2>().norm()) <= params.nudge_m;
                  })
      .has_value();
}

double continued_share(const RoomPair& pair, const segment::Indices& points, const NovelParams& params) {
  return share_of(points, [&](std::uint32_t i) { return continues(pair, i, params); });
}

double nudged_share(const RoomPair& pair, const segment::Indices& points, const NovelParams& params) {
  return share_of(points, [&](std::uint32_t i) { return nudged(pair, i, params); });
}

}  // namespace amiss::change::internal
