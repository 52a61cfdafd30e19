#include "motion/path_planner.hpp"

#include <cmath>

#include "motion/internal/grid_search.hpp"
#include "motion/internal/sampling_planner.hpp"
#include "motion/internal/way_cost.hpp"

namespace amiss::motion {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using Planned = Result<PlannedPath, NavigationError>;

constexpr double kGoodEnough = 1.005;  // a way at most so much longer than the straight line is not improved

bool on_map(const DriveMap& map, const Eigen::Vector2d& p) {
  return p.allFinite() && p.cwiseAbs().maxCoeff() < 1e6 && map.grid().contains(map.grid().cell_at(p));
}

/// The cell nearest to `goal` within the tolerance that the search has reached.
std::optional<Cell> nearest_reached(const DriveMap& map, const internal::SearchField& field,
                                    const Eigen::Vector2d& goal, double tolerance_m) {
  const FloorGrid& grid = map.grid();
  const Cell middle = grid.cell_at(goal);
  const int reach = static_cast<int>(std::ceil(tolerance_m / grid.resolution_m()));
  std::optional<Cell> nearest;
  double nearest_m = tolerance_m;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const Cell c{x, y};
      if (!grid.contains(c) || !std::isfinite(field.cost_m[grid.index(c)])) continue;
      const double d = (grid.centre_of(c) - goal).norm();
      if (d > nearest_m || (nearest && d == nearest_m)) continue;
      nearest = c;
      nearest_m = d;
    }
  }
  return nearest;
}

struct Ends {
  Cell start_cell, goal_cell;
  Eigen::Vector2d start, goal;
};

/// The grid's way with the exact ends; within their cells the line to the centre is always passable.
Points grid_way(const DriveMap& map, const internal::SearchField& field, const Ends& ends) {
  Points way{ends.start};
  for (const Cell c : internal::trace(map.grid(), field, ends.goal_cell)) way.push_back(map.grid().centre_of(c));
  way.push_back(ends.goal);
  return way;
}

/// Fills in the way and what is to be said about it.
PlannedPath find_way(const DriveMap& map, const internal::SearchField& field, const Ends& ends,
                     const PlannerParams& params, RandomStream& random) {
  PlannedPath planned;
  const double weight = params.clearance_weight;
  Points way = internal::shortened(map, grid_way(map, field, ends), weight);
  planned.cost_m = planned.grid_cost_m = internal::way_cost_m(map, way, weight);
  const double straight_m = (ends.goal - ends.start).norm();
  if (params.iterations > 0 && way.size() > 1 && planned.cost_m > kGoodEnough * straight_m) {
    const auto sampled = internal::sample_way(map, {way, weight, params.iterations}, random);
    if (sampled) {
      Points other = internal::shortened(map, *sampled, weight);
      const double cost_m = internal::way_cost_m(map, other, weight);
      planned.sampled = cost_m < planned.cost_m;
      if (planned.sampled) {
        planned.cost_m = cost_m;
        way = std::move(other);
      }
    }
  }
  planned.path.points_m = std::move(way);
  planned.min_clearance_m = min_clearance_m(map, planned.path);
  return planned;
}

}  // namespace

void describe(ParamTable& table, PlannerParams& p) {
  table.integer("path.iterations", p.iterations, 0, 100000, "iterations of Informed RRT*; 0: the grid's path alone");
  table.number("path.escape", p.escape_m, "m", 0.0, 5.0, "how far a start too near to something may be left");
  table.number("path.goal_tolerance", p.goal_tolerance_m, "m", 0.0, 5.0, "how far a blocked goal may be moved");
  table.number("path.clearance_weight", p.clearance_weight, "", 0.0, 20.0,
               "extra cost of a metre at the robot's radius");
}

std::string_view to_string(NavigationError error) {
  switch (error) {
    case NavigationError::kStartOutsideMap:
      return "start_outside_map";
    case NavigationError::kStartOccupied:
      return "start_occupied";
    case NavigationError::kGoalOutsideMap:
      return "goal_outside_map";
    case NavigationError::kGoalOccupied:
      return "goal_occupied";
    case NavigationError::kNoPath:
      return "no_path";
  }
  return "";
}

Planned plan_path(const DriveMap& map, const Pose2<Map, Base>& start, const Pose2<Map, Base>& goal,
                  const PlannerParams& params, RandomStream& random) {
  if (!on_map(map, start.position())) return Planned::failure(NavigationError::kStartOutsideMap);
  if (!on_map(map, goal.position())) return Planned::failure(NavigationError::kGoalOutsideMap);
  const std::optional<Cell> start_cell = map.nearest_passable(start.position(), params.escape_m);
  if (!start_cell) return Planned::failure(NavigationError::kStartOccupied);

  Ends ends{*start_cell, map.grid().cell_at(goal.position()), start.position(), goal.position()};
  const bool escaped = map.grid().cell_at(start.position()) != *start_cell;
  if (escaped) ends.start = map.grid().centre_of(*start_cell);
  internal::SearchLimits limits{params.clearance_weight, std::nullopt};
  const bool goal_passable = map.passable(ends.goal_cell);
  if (goal_passable) limits.goal = ends.goal_cell;
  const internal::SearchField field = internal::search(map, *start_cell, 0.0F, limits);
  const bool reached = goal_passable && std::isfinite(field.cost_m[map.grid().index(ends.goal_cell)]);
  if (!reached) {
    const auto other = nearest_reached(map, field, goal.position(), params.goal_tolerance_m);
    if (!other) return Planned::failure(goal_passable ? NavigationError::kNoPath : NavigationError::kGoalOccupied);
    ends.goal_cell = *other;
    ends.goal = map.grid().centre_of(*other);
  }
  PlannedPath planned = find_way(map, field, ends, params, random);
  planned.escaped = escaped;
  planned.goal_moved_m = (ends.goal - goal.position()).norm();
  planned.path.final_yaw_rad = goal.yaw_rad;
  if (escaped) {
    Points with_escape{start.position()};
    for (const Eigen::Vector2d& p : planned.path.points_m) with_escape.push_back(p);
    planned.path.points_m = std::move(with_escape);
  }
  return planned;
}

}  // namespace amiss::motion
