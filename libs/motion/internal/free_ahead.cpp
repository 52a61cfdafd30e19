#include "motion/internal/free_ahead.hpp"

#include <algorithm>
#include <cmath>

#include "core/line_cells.hpp"

namespace amiss::motion::internal {
namespace {

constexpr double kGlancing = 0.2;   // cosine: nearly tangential motion past something near is not towards it
constexpr double kShrink_m = 0.02;  // of clearance that counts as rounding by cells
constexpr double kDeep = 0.93;      // part of the stop radius under which no approach at all is allowed

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

double free_by_hits_m(std::span<const Eigen::Vector2d> hits_base, const Eigen::Vector2d& direction_base,
                      double stop_radius_m, double look_m) {
  double free_m = look_m;
  for (const Eigen::Vector2d& hit : hits_base) {
    const double ahead_m = hit.dot(direction_base);
    if (ahead_m <= 0.0) continue;
    const double range_m = hit.norm();
    if (range_m <= stop_radius_m) {
      const double glancing = range_m < kDeep * stop_radius_m ? 0.0 : kGlancing;
      if (ahead_m > glancing * range_m) return 0.0;
      continue;
    }
    const double aside_m = cross(direction_base, hit);
    if (std::abs(aside_m) >= stop_radius_m) continue;
    free_m = std::min(free_m, ahead_m - std::sqrt(stop_radius_m * stop_radius_m - aside_m * aside_m));
  }
  return free_m;
}

double free_by_map_m(const DriveMap& map, const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map,
                     double stop_radius_m) {
  const double length_m = (to_map - from_map).norm();
  double needed_m = stop_radius_m;
  double free_m = length_m;
  for_line_cells(map.grid(), from_map, to_map, [&](Cell c, double begin, double) {
    const auto clearance_m = static_cast<double>(map.clearance_at(c));
    if (begin == 0.0) needed_m = std::min(needed_m, clearance_m - kShrink_m);
    const bool stops = map.grid().at(c) != Occupancy::kFree && begin > 0.0;
    if (stops || clearance_m < needed_m) {
      free_m = begin * length_m;
      return false;
    }
    needed_m = std::max(needed_m, std::min(stop_radius_m, clearance_m - kShrink_m));
    return true;
  });
  return free_m;
}

Eigen::Vector2d away_from_sides(std::span<const Eigen::Vector2d> hits_base, const Eigen::Vector2d& direction_base,
                                double stop_radius_m, double range_m) {
  double left_m = range_m, right_m = range_m;
  for (const Eigen::Vector2d& hit : hits_base) {
    const double aside_m = cross(direction_base, hit);
    // Only what lies beside, where going on does not change the distance much.
    if (std::abs(hit.dot(direction_base)) > range_m) continue;
    double& nearest_m = aside_m > 0.0 ? left_m : right_m;
    nearest_m = std::min(nearest_m, hit.norm());
  }
  const double span_m = range_m - stop_radius_m;
  const double push = (std::min(1.0, (range_m - right_m) / span_m) - std::min(1.0, (range_m - left_m) / span_m));
  return push * Eigen::Vector2d(-direction_base.y(), direction_base.x());
}

}  // namespace amiss::motion::internal
