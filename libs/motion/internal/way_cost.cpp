#include "motion/internal/way_cost.hpp"

#include <cmath>
#include <limits>

#include "core/line_cells.hpp"
#include "motion/internal/grid_search.hpp"

namespace amiss::motion::internal {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kSpacing_m = 0.30;  // corners that a cut may begin and end at
constexpr double kSlack_m = 1e-6;

/// Without the points between which the way is straight.
Points without_straight_points(const Points& points) {
  Points kept;
  for (const Eigen::Vector2d& p : points) {
    if (!kept.empty() && (p - kept.back()).norm() < 1e-9) continue;
    while (kept.size() >= 2) {
      const Eigen::Vector2d before = kept.back() - kept[kept.size() - 2], after = p - kept.back();
      const double cross = before.x() * after.y() - before.y() * after.x();
      if (std::abs(cross) > 1e-6 * before.norm() * after.norm() || before.dot(after) < 0.0) break;
      kept.pop_back();
    }
    kept.push_back(p);
  }
  return kept;
}

Points with_points_between(const Points& points) {
  Points dense{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector2d way = points[i] - points[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() / kSpacing_m)));
    for (int part = 1; part < parts; ++part) dense.emplace_back(points[i - 1] + way * part / parts);
    dense.push_back(points[i]);
  }
  return dense;
}

/// From each kept corner on to the farthest one that the straight line reaches as cheaply.
Points cut(const DriveMap& map, const Points& points, double clearance_weight) {
  std::vector<double> cost_to{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    cost_to.push_back(cost_to.back() + line_cost_m(map, points[i - 1], points[i], clearance_weight));
  }
  Points kept{points.front()};
  for (std::size_t i = 0; i + 1 < points.size();) {
    std::size_t next = points.size() - 1;
    while (next > i + 1) {
      const double along_m = cost_to[next] - cost_to[i];
      if ((points[next] - points[i]).norm() <= along_m &&
          line_cost_m(map, points[i], points[next], clearance_weight) <= along_m + kSlack_m) {
        break;
      }
      --next;
    }
    kept.push_back(points[next]);
    i = next;
  }
  return kept;
}

}  // namespace

double line_cost_m(const DriveMap& map, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double clearance_weight) {
  double weighted = 0.0;
  const bool passable = for_line_cells(map.grid(), a, b, [&](Cell c, double begin, double end) {
    if (!map.passable(c)) return false;
    weighted += (end - begin) * static_cast<double>(weight_at(map.params(), clearance_weight, map.clearance_at(c)));
    return true;
  });
  return passable ? weighted * (b - a).norm() : std::numeric_limits<double>::infinity();
}

double way_cost_m(const DriveMap& map, const std::vector<Eigen::Vector2d>& points, double clearance_weight) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += line_cost_m(map, points[i - 1], points[i], clearance_weight);
  return sum;
}

std::vector<Eigen::Vector2d> shortened(const DriveMap& map, const std::vector<Eigen::Vector2d>& points,
                                       double clearance_weight) {
  Points way = without_straight_points(points);
  for (int round = 0; round < 2 && way.size() > 2; ++round) {
    way = without_straight_points(cut(map, with_points_between(way), clearance_weight));
  }
  return way;
}

}  // namespace amiss::motion::internal
