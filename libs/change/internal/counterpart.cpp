#include "change/internal/counterpart.hpp"

#include <algorithm>
#include <set>

namespace amiss::change::internal {

namespace {

/// Is there a point of the current scene at p (current frame) that is not one of `except` (ascending)?
bool is_there(const RoomPair& pair, const Eigen::Vector3f& p, float distance_m, const segment::Indices& except) {
  bool found = false;
  pair.current.grid.for_each_within(p, distance_m, [&](std::uint32_t i, float) {
    found = found || !std::binary_search(except.begin(), except.end(), i);
  });
  return found;
}

bool is_empty(const mapping::VoxelMap* space, const Eigen::Vector3f& p) {
  return space == nullptr || space->at(p.cast<double>()) == Occupancy::kFree;
}

struct Matches {
  std::set<std::uint32_t> stuff;  // positions in pair.stuff
  std::vector<float> colour_distances;
};

Matches matches_of(const RoomPair& pair, const segment::Indices& candidate, const Fit& fit, float d) {
  Matches matches;
  for (const std::uint32_t i : candidate) {
    const Eigen::Vector3f p = fit.T * pair.placed[i];
    float best = d * d;
    std::optional<std::uint32_t> nearest;
    pair.stuff_grid.for_each_within(p, d, [&](std::uint32_t k, float squared) {
      matches.stuff.insert(k);
      if (squared > best) return;
      best = squared;
      nearest = k;
    });
    if (!nearest || pair.reference.colours.empty() || pair.current.colours.empty()) continue;
    const Eigen::Vector3f& before = pair.reference.colours[pair.stuff[*nearest]];
    matches.colour_distances.push_back((pair.current.colours[i] - before).norm());
  }
  return matches;
}

}  // namespace

Counterpart counterpart_of(const RoomPair& pair, const segment::Indices& candidate, const Fit& fit,
                           const NovelParams& params) {
  const auto d = static_cast<float>(params.difference_m), near = static_cast<float>(params.filter_distance_m);
  Matches matches = matches_of(pair, candidate, fit, d);
  Counterpart out;
  if (matches.stuff.empty()) return out;
  if (!matches.colour_distances.empty()) {
    auto middle = matches.colour_distances.begin() + std::ssize(matches.colour_distances) / 2;
    std::nth_element(matches.colour_distances.begin(), middle, matches.colour_distances.end());
    out.colour_distance = static_cast<double>(*middle);
  }
  // From the matched stuff on over all that is connected with it and has gone.
  const auto place = [&](std::uint32_t k) { return pair.reference.points[pair.stuff[k]]; };
  const Eigen::Isometry3f T_current_reference = pair.drift.at(place(*matches.stuff.begin())).inverse();
  const Eigen::Isometry3f T_now = T_current_reference * fit.T.inverse();  // where the counterpart would be now
  std::vector<std::uint32_t> gone;
  std::set<std::uint32_t> visited;
  std::size_t taken = 0;
  const auto visit = [&](std::uint32_t k) {
    if (!visited.insert(k).second) return false;
    const Eigen::Vector3f was = T_current_reference * place(k);
    const bool there = is_there(pair, was, d, candidate);
    if (!there) gone.push_back(k);
    return there;
  };
  for (const std::uint32_t k : matches.stuff) taken += visit(k) ? 1U : 0U;
  const Eigen::Vector3f first = place(*matches.stuff.begin());
  const auto reach = static_cast<float>(2.0 * params.max_size_m);
  std::size_t empty = 0;
  for (std::size_t next = 0; next < gone.size(); ++next) {
    const Eigen::Vector3f p = place(gone[next]);
    const Eigen::Vector3f now = T_now * p;
    if (!pair.current.grid.any_within(now, near) && is_empty(pair.current_space, now)) ++empty;
    if ((p - first).squaredNorm() > reach * reach) continue;
    pair.stuff_grid.for_each_within(p, near, [&](std::uint32_t k, float) { visit(k); });
  }
  out.taken = static_cast<double>(taken) / static_cast<double>(matches.stuff.size());
  if (!gone.empty()) out.left_over = static_cast<double>(empty) / static_cast<double>(gone.size());
  return out;
}

}  // namespace amiss::change::internal
