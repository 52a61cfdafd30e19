#include "motion/path_lengths.hpp"

#include <algorithm>
#include <cmath>

#include "motion/internal/grid_search.hpp"

namespace amiss::motion {

PathLengths::PathLengths(const DriveMap& map, const Eigen::Vector2d& from_map, double escape_m)
    : geometry_(map.grid()) {
  const std::optional<Cell> start = map.nearest_passable(from_map, escape_m);
  if (!start) {
    field_.cost_m.assign(geometry_.cells().size(), kUnreachable);
    field_.came_from.assign(geometry_.cells().size(), internal::kNoMove);
    return;
  }
  const double escaped_m =
      geometry_.cell_at(from_map) == *start ? 0.0 : (geometry_.centre_of(*start) - from_map).norm();
  field_ = internal::search(map, *start, static_cast<float>(escaped_m), {});
}

std::optional<Cell> PathLengths::nearest(const Eigen::Vector2d& p_map, double tolerance_m) const {
  const Cell middle = geometry_.cell_at(p_map);
  if (to(middle) < kUnreachable) return middle;
  const int reach = static_cast<int>(std::ceil(tolerance_m / geometry_.resolution_m()));
  std::optional<Cell> best;
  double nearest_m = tolerance_m;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const Cell c{x, y};
      const double d = (geometry_.centre_of(c) - p_map).norm();
      if (to(c) == kUnreachable || d > nearest_m || (best && d == nearest_m && to(c) >= to(*best))) continue;
      nearest_m = d;
      best = c;
    }
  }
  return best;
}

float PathLengths::near(const Eigen::Vector2d& p_map, double tolerance_m) const {
  const std::optional<Cell> cell = nearest(p_map, tolerance_m);
  if (!cell) return kUnreachable;
  if (*cell == geometry_.cell_at(p_map)) return to(*cell);
  return to(*cell) + static_cast<float>((geometry_.centre_of(*cell) - p_map).norm());
}

std::vector<Eigen::Vector2d> PathLengths::way_to(const Eigen::Vector2d& p_map) const {
  std::vector<Eigen::Vector2d> way;
  for (const Cell c : internal::trace(geometry_, field_, geometry_.cell_at(p_map))) {
    way.push_back(geometry_.centre_of(c));
  }
  return way;
}

std::vector<double> way_matrix(const DriveMap& map, std::span<const Eigen::Vector2d> places_map, double tolerance_m) {
  const std::size_t n = places_map.size();
  std::vector<double> lengths_m(n * n, 0.0);
  if (n == 0) return lengths_m;
  const PathLengths from_first(map, places_map[0], tolerance_m);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    PathLengths from = i == 0 ? from_first : PathLengths(map, places_map[i], tolerance_m);
    const std::optional<Cell> reached = from_first.nearest(places_map[i], tolerance_m);
    if (reached && from.to(*reached) == PathLengths::kUnreachable) {
      from = PathLengths(map, map.grid().centre_of(*reached), 0.0);
    }
    for (std::size_t j = i + 1; j < n; ++j) {
      lengths_m[i * n + j] = static_cast<double>(from.near(places_map[j], tolerance_m));
      lengths_m[j * n + i] = lengths_m[i * n + j];
    }
  }
  return lengths_m;
}

}  // namespace amiss::motion
