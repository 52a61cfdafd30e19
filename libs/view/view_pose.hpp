// From where to examine a region of interest (thesis 4.2.6): a cylinder, where the robot can be, what stops sight
// -> poses of the base in the map frame with pan and tilt of the head, best first.
// Of a ring of ideal viewpoints, those that cannot be reached or do not see the region are replaced by a near one or
// ruled out. In a view the whole cylinder with its margin lies inside the image, its middle in the middle, and no part
// of it is nearer than the camera can measure.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/floor_grid.hpp"
#include "core/params.hpp"
#include "view/head.hpp"

namespace amiss::view {

struct PoseParams {
  double exam_dist_m = 0.4;       // robot centre to the boundary, at least
  double preferred_dist_m = 0.6;  // robot centre to the boundary, of the ideal ring
  double max_dist_m = 1.5;        // robot centre to the boundary, at most
  double exam_step_rad = radians(60);
  double margin_m = 0.15;  // round the cylinder, inside the image
  double min_depth_m = 0.4;
  double travel_weight = 0.15;    // cost of a metre of way beside a metre of deviation from the ideal
  double min_clear_share = 0.75;  // of the rays to the region that must be free
};
void describe(ParamTable& table, PoseParams& params);

/// Upright cylinder in the map frame.
struct Cylinder {
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
  double height_m = 0.0;
};

struct ViewPose {
  Pose2<Map, Base> T_map_base;
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  double distance_m = 0.0;   // camera to the middle of the region
  double clear_share = 0.0;  // of the rays to the region
  double travel_m = 0.0;
  double cost = 0.0;  // what the order goes by, less is better
};

/// Is nothing known to be occupied between the two points of the map frame?
using SightTest = std::function<bool(const Eigen::Vector3d& from_map, const Eigen::Vector3d& to_map)>;

/// `travel_m`: row-major as `grid`, way from the robot to a cell, infinite where its centre cannot be.
[[nodiscard]] std::vector<ViewPose> view_poses(const Cylinder& region, const FloorGrid& grid,
                                               std::span<const float> travel_m, const SightTest& clear,
                                               const Head& head, const PoseParams& params);

}  // namespace amiss::view
