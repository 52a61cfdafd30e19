// Frontiers for the mapping run: free cells beside unknown ones, clustered, each with a place to drive to.
// FloorGrid, way lengths -> goals in the map frame, best first (Yamauchi 1997; utility: length against way).
#pragma once

#include <span>
#include <vector>

#include "core/floor_grid.hpp"
#include "core/params.hpp"

namespace amiss::view {

struct FrontierParams {
  double min_length_m = 0.30;  // shorter ones are gaps in the scan, not space
  double goal_radius_m = 1.0;  // a goal lies at most so far from its frontier
  double travel_weight = 0.5;  // metres of frontier that a metre of way costs
};
void describe(ParamTable& table, FrontierParams& params);

struct Frontier {
  std::vector<Cell> cells;                             // in row-major order
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  // of its cell that is nearest to the mean of all
  double length_m = 0.0;
  Pose2<Map, Base> goal;  // where the robot can be, facing the frontier
  double travel_m = 0.0;
  double utility = 0.0;
};

/// `travel_m`: row-major as `grid`, way from the robot to a cell, infinite where its centre cannot be. Frontiers
/// without a goal are left out.
[[nodiscard]] std::vector<Frontier> frontiers(const FloorGrid& grid, std::span<const float> travel_m,
                                              const FrontierParams& params);

}  // namespace amiss::view
