// Objects on the floor in one RGB-D frame: crop by a region's bounding cylinder, RANSAC ground plane, clusters by
// proximity, smoothness and colour (Section 4.2.7).
// In: frame (depth in metres along z of the camera), T_map_camera, the cylinder in the map frame [m]. Out: segments,
// largest first, with points in the map frame and row-major pixel indices of the frame.
// Expected failures stand in the result: no ground plane, no segments. Repeatable: the RANSAC has a fixed seed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/frames.hpp"
#include "core/params.hpp"
#include "core/sensors.hpp"

namespace amiss::segment {

struct Params {
  double crop_margin_m = 0.15;      // mu of Table 4.1
  double plane_distance_m = 0.007;  // of points that belong to the ground
  double plane_tilt_rad = radians(12.0);
  double plane_offset_m = 0.06;         // of the ground from z = 0 of the map
  double neighbour_distance_m = 0.025;  // proximity
  double min_normal_dot = 0.85;         // smoothness
  double max_colour_distance = 60.0;    // of two neighbours, Euclidean in RGB of 0..255
  double gap_m = 0.02;                  // pieces that are nearer belong together
  int min_points = 25;                  // of a segment
  double max_range_m = 3.5;             // of depth that is used
  double max_base_m = 0.10;             // height above the ground at which a segment begins
  double max_height_m = 0.55;           // of a segment above the ground
  double max_size_m = 0.8;              // horizontal extent of a segment
};
void describe(ParamTable& table, Params& p);

/// Upright cylinder in the map frame.
struct Cylinder {
  Eigen::Vector2d centre_map = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  double z_low_m = 0.0;
  double z_high_m = 0.0;
};

/// normal_map . p + d_m = 0; the normal is a unit vector that points up.
struct Plane {
  Eigen::Vector3d normal_map = Eigen::Vector3d::UnitZ();
  double d_m = 0.0;
  int inliers = 0;
};

struct Segment {
  std::vector<std::uint32_t> pixels;                     // row-major indices of the frame, ascending
  Cloud<Map> cloud;                                      // points, colours and normals of these pixels
  Eigen::Vector3d centre_map = Eigen::Vector3d::Zero();  // of the object, its unseen back completed [m]
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();      // length, width (horizontal, length >= width), height
  double yaw_rad = 0.0;                                  // direction of the length in the map
  int points = 0;
  bool cut = false;            // touches the border of the crop or of the image: there may be more of it
  double mean_height_m = 0.0;  // of its points above the ground
  Rgb mean_colour;
};

/// The segments, and why they should be believed.
struct Segmentation {
  std::vector<Segment> segments;
  std::optional<Plane> ground;
  int points_in_crop = 0;
  int points_above_ground = 0;
  int pieces = 0;   // clusters before merging
  int dropped = 0;  // clusters that are too small, too large, or stand out of the crop (walls, furniture)
};

/// The things inside the cylinder grown by the crop margin in each direction.
[[nodiscard]] Segmentation segment_region(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera,
                                          const Cylinder& region, const Params& params);

/// The things on the floor of the whole frame (the static baseline).
[[nodiscard]] Segmentation segment_frame(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera,
                                         const Params& params);

}  // namespace amiss::segment
