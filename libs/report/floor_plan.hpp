// A floor plan for people: grid, path, view triangles, regions and objects -> PNG bytes. Map frame, metres, y up.
#pragma once

#include <string>
#include <vector>

#include "core/floor_grid.hpp"

namespace amiss::report {

struct PlannedView {
  Pose2<Map, Base> T_map_base;
  double angle_rad = 0.0, height_m = 0.0;
  bool visited = false;
};
struct PlannedCircle {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  bool withdrawn = false;
};
struct PlannedMark {
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
  std::string label;
  bool found = false;
};

struct FloorPlan {
  FloorGrid grid;
  FloorGrid seen;  // floor that was seen (may be empty)
  std::vector<Eigen::Vector2d> path_m;
  std::vector<PlannedView> views;
  std::vector<PlannedCircle> regions;
  std::vector<PlannedMark> objects;
};

[[nodiscard]] std::string to_png(const FloorPlan& plan);

/// A colour image -> PNG bytes.
[[nodiscard]] std::string to_png(const std::vector<Rgb>& pixels, int width, int height);

}  // namespace amiss::report
