// Where to look from so that the floor is seen: random view triangles and a greedy cover (thesis 4.2.2, Figure 4.3).
// FloorGrid that stops sight, way lengths (infinite where the robot cannot be) -> poses of the base in the map frame,
// each with the floor cells that it sees. The apex of a triangle is the middle of the base, its axis the base's x axis.
// Greedy cover with lazy evaluation: Nemhauser, Wolsey and Fisher 1978; Minoux 1978.
#pragma once

#include <span>
#include <vector>

#include "core/floor_grid.hpp"
#include "core/params.hpp"
#include "core/random.hpp"

namespace amiss::view {

struct TriangleParams {
  int samples = 1000;
  double angle_rad = radians(58);
  double height_m = 2.0;
  double coverage_goal = 0.55;  // of what is open; about 20 triangles for 90 m2 and 10 for 30 m2
  double min_gain_m2 = 0.3;
  int max_triangles = 100;
  double drop_above = 0.90;
};
void describe(ParamTable& table, TriangleParams& params);

struct ViewTriangle {
  Pose2<Map, Base> T_map_base;
  double angle_rad = 0.0;
  double height_m = 0.0;
  std::vector<Eigen::Vector2f> floor_m;  // centres of the free cells inside it that nothing hides, map frame
  double gain_m2 = 0.0;                  // what it added to the cover when it was chosen
};

struct TriangleCover {
  std::vector<ViewTriangle> triangles;  // in the order in which they were chosen, best first
  double coverage = 0.0;                // part of the target that is covered, with what was covered before
  double target_m2 = 0.0;               // free floor that is connected with a place where the robot can be
  int evaluations = 0;                  // of the gain of a triangle
};

/// `sight`: free cells are floor that can be seen, all others stop sight. `travel_m`: row-major as `sight`, way from
/// the robot to a cell, infinite where its centre cannot be. `covered`: floor that needs no look, cells other than
/// unknown count (any geometry; an empty grid for nothing). Asked again with what was seen meanwhile it gives the next
/// set, and none when no triangle adds enough.
[[nodiscard]] TriangleCover cover_with_triangles(const FloorGrid& sight, std::span<const float> travel_m,
                                                 const FloorGrid& covered, const TriangleParams& params,
                                                 RandomStream& random);

/// The triangle of one pose and what it sees.
[[nodiscard]] ViewTriangle view_triangle(const FloorGrid& sight, const Pose2<Map, Base>& T_map_base,
                                         const TriangleParams& params);

/// Part of the floor of a triangle that is known in `seen` (1 for a triangle that sees no floor): above
/// `drop_above` it is not worth the way.
[[nodiscard]] double covered_fraction(const ViewTriangle& triangle, const FloorGrid& seen);

}  // namespace amiss::view
