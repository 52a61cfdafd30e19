#include "view/frontier.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace amiss::view {
namespace {

constexpr std::array<Cell, 4> kSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

bool is_frontier(const FloorGrid& grid, Cell c) {
  return grid.at(c) == Occupancy::kFree && std::any_of(kSides.begin(), kSides.end(), [&](Cell side) {
           const Cell beside{c.x + side.x, c.y + side.y};
           return grid.contains(beside) && grid.at(beside) == Occupancy::kUnknown;
         });
}

/// Cells of value 1 that touch each other (8 neighbours), row-major; they become 0.
std::vector<Cell> take_cluster(const FloorGrid& grid, std::vector<char>& marked, Cell seed) {
  std::vector<Cell> cluster{seed};
  marked[grid.index(seed)] = 0;
  for (std::size_t next = 0; next < cluster.size(); ++next) {
    const Cell c = cluster[next];
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell beside{c.x + dx, c.y + dy};
        if (!grid.contains(beside) || marked[grid.index(beside)] == 0) continue;
        marked[grid.index(beside)] = 0;
        cluster.push_back(beside);
      }
    }
  }
  std::sort(cluster.begin(), cluster.end(), [](Cell a, Cell b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  return cluster;
}

Eigen::Vector2d middle_of(const FloorGrid& grid, const std::vector<Cell>& cells) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Cell c : cells) mean += grid.centre_of(c);
  mean /= static_cast<double>(cells.size());
  const auto nearest = std::min_element(cells.begin(), cells.end(), [&](Cell a, Cell b) {
    return (grid.centre_of(a) - mean).squaredNorm() < (grid.centre_of(b) - mean).squaredNorm();
  });
  return grid.centre_of(*nearest);
}

/// The place nearest to the middle of the frontier where the robot can be; the shorter way decides a tie.
bool find_goal(const FloorGrid& grid, std::span<const float> travel_m, double radius_m, Frontier& frontier) {
  const Cell middle = grid.cell_at(frontier.middle_m);
  const int reach = static_cast<int>(std::ceil(radius_m / grid.resolution_m()));
  double best_m = radius_m;
  bool found = false;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const Cell c{x, y};
      if (!grid.contains(c) || !std::isfinite(travel_m[grid.index(c)])) continue;
      const Eigen::Vector2d ahead = frontier.middle_m - grid.centre_of(c);
      const double way_m = static_cast<double>(travel_m[grid.index(c)]);
      const bool nearer = ahead.norm() < best_m - 1e-9;
      const bool as_near = found && std::abs(ahead.norm() - best_m) <= 1e-9;
      if (!nearer && !(as_near && way_m < frontier.travel_m)) continue;
      found = true;
      best_m = ahead.norm();
      frontier.travel_m = way_m;
      const Eigen::Vector2d place = grid.centre_of(c);
      frontier.goal = {place.x(), place.y(), std::atan2(ahead.y(), ahead.x())};
    }
  }
  return found;
}

}  // namespace

void describe(ParamTable& table, FrontierParams& p) {
  table.number("frontier.min_length", p.min_length_m, "m", 0.0, 10.0, "shorter frontiers are gaps in a scan");
  table.number("frontier.goal_radius", p.goal_radius_m, "m", 0.1, 10.0, "how far from its frontier a goal may lie");
  table.number("frontier.travel_weight", p.travel_weight, "", 0.0, 100.0, "metres of frontier a metre of way costs");
}

std::vector<Frontier> frontiers(const FloorGrid& grid, std::span<const float> travel_m, const FrontierParams& params) {
  assert(travel_m.size() == grid.cells().size());
  std::vector<char> marked(grid.cells().size(), 0);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) marked[grid.index({x, y})] = is_frontier(grid, {x, y}) ? 1 : 0;
  }
  std::vector<Frontier> found;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (marked[grid.index({x, y})] == 0) continue;
      Frontier frontier;
      frontier.cells = take_cluster(grid, marked, {x, y});
      frontier.length_m = static_cast<double>(frontier.cells.size()) * grid.resolution_m();
      if (frontier.length_m < params.min_length_m) continue;
      frontier.middle_m = middle_of(grid, frontier.cells);
      if (!find_goal(grid, travel_m, params.goal_radius_m, frontier)) continue;
      frontier.utility = frontier.length_m - params.travel_weight * frontier.travel_m;
      found.push_back(std::move(frontier));
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Frontier& a, const Frontier& b) { return a.utility > b.utility; });
  return found;
}

}  // namespace amiss::view
