#include "motion/path.hpp"

#include <algorithm>

#include "core/line_cells.hpp"

namespace amiss::motion {

double Path::length_m() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < points_m.size(); ++i) sum += (points_m[i] - points_m[i - 1]).norm();
  return sum;
}

double min_clearance_m(const DriveMap& map, const Path& path, double from_m) {
  double least = map.params().clearance_cap_m;
  const auto look = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    for_line_cells(map.grid(), a, b, [&](Cell c, double, double) {
      const bool is_free = map.grid().at(c) == Occupancy::kFree;
      least = is_free ? std::min(least, static_cast<double>(map.clearance_at(c))) : 0.0;
      return is_free;
    });
  };
  double before_m = 0.0;
  for (std::size_t i = 1; i < path.points_m.size() && least > 0.0; ++i) {
    const Eigen::Vector2d a = path.points_m[i - 1], b = path.points_m[i];
    const double length_m = (b - a).norm();
    if (before_m + length_m >= from_m) {
      const double skipped = length_m > 0.0 ? std::clamp((from_m - before_m) / length_m, 0.0, 1.0) : 0.0;
      look(a + skipped * (b - a), b);
    }
    before_m += length_m;
  }
  if (!path.points_m.empty() && least > 0.0) look(path.points_m.back(), path.points_m.back());
  return path.points_m.empty() ? 0.0 : least;
}

bool straight_passable(const DriveMap& map, const Eigen::Vector2d& a_map, const Eigen::Vector2d& b_map) {
  return for_line_cells(map.grid(), a_map, b_map, [&](Cell c, double, double) { return map.passable(c); });
}

}  // namespace amiss::motion
