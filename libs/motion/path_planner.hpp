// Pose now, pose wanted -> Path that keeps the robot's radius from what is occupied and prefers more.
// A weighted grid search says whether there is a way at all; Informed RRT* (Gammell 2014, OMPL), whose samples favour
// the surroundings of that way, makes it shorter and smoother; then corners are cut. The cheaper one wins.
// Bounded by iterations, not by time; the same random stream gives the same path.
#pragma once

#include <string_view>

#include "core/random.hpp"
#include "core/result.hpp"
#include "motion/path.hpp"

namespace amiss::motion {

struct PlannerParams {
  int iterations = 120;           // of the sampling planner; 0: the grid path alone
  double escape_m = 0.5;          // a start too near to something may be left this far
  double goal_tolerance_m = 0.0;  // a goal too near to something may be moved this far
  double clearance_weight = 1.5;  // a metre at the robot's radius costs 1 + this, one at the preferred clearance 1
};
void describe(ParamTable& table, PlannerParams& params);

enum class NavigationError { kStartOutsideMap, kStartOccupied, kGoalOutsideMap, kGoalOccupied, kNoPath };
[[nodiscard]] std::string_view to_string(NavigationError error);

struct PlannedPath {
  Path path;
  double cost_m = 0.0;           // length weighted by clearance
  double grid_cost_m = 0.0;      // of the grid path after cutting its corners
  double min_clearance_m = 0.0;  // after the escape from the start
  double goal_moved_m = 0.0;
  bool escaped = false;  // the start was too near to something
  bool sampled = false;  // the sampling planner's path won
};

[[nodiscard]] Result<PlannedPath, NavigationError> plan_path(const DriveMap& map, const Pose2<Map, Base>& start,
                                                             const Pose2<Map, Base>& goal, const PlannerParams& params,
                                                             RandomStream& random);

}  // namespace amiss::motion
