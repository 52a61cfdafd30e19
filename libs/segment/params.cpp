#include "core/params.hpp"

#include "segment/segment.hpp"
#include "segment/support_planes.hpp"

namespace amiss::segment {

void describe(ParamTable& table, Params& p) {
  table.number("segment.crop_margin", p.crop_margin_m, "m", 0.0, 1.0, "margin round a region's cylinder (mu)");
  table.number("segment.plane_distance", p.plane_distance_m, "m", 0.001, 0.05, "of points that belong to the ground");
  table.number("segment.plane_tilt", p.plane_tilt_rad, "deg", 1.0, 45.0, "largest tilt of the ground");
  table.number("segment.plane_offset", p.plane_offset_m, "m", 0.005, 0.5, "largest distance of the ground from z = 0");
  table.number("segment.neighbour_distance", p.neighbour_distance_m, "m", 0.005, 0.2,
               "proximity of points of one cluster");
  table.number("segment.min_normal_dot", p.min_normal_dot, "1", -1.0, 1.0, "smoothness: dot product of normals");
  table.number("segment.max_colour_distance", p.max_colour_distance, "1", 0.0, 442.0,
               "colour difference of neighbours, Euclidean in RGB");
  table.number("segment.gap", p.gap_m, "m", 0.0, 0.2, "pieces that are nearer belong together");
  table.integer("segment.min_points", p.min_points, 1, 100000, "points of a segment");
  table.number("segment.max_range", p.max_range_m, "m", 0.5, 10.0, "depth that is used");
  table.number("segment.max_base", p.max_base_m, "m", 0.01, 1.0, "height at which a segment begins");
  table.number("segment.max_height", p.max_height_m, "m", 0.1, 3.0, "height of a segment");
  table.number("segment.max_size", p.max_size_m, "m", 0.05, 5.0, "horizontal extent of a segment");
}

void describe(ParamTable& table, SupportPlaneParams& p) {
  table.number("planes.distance", p.distance_m, "m", 0.001, 0.05, "of points that belong to a plane (tau_r_dist)");
  table.number("planes.max_tilt", p.max_tilt_rad, "deg", 0.0, 30.0, "of a plane (tau_r_angle)");
  table.number("planes.max_normal_tilt", p.max_normal_tilt_rad, "deg", 1.0, 60.0, "of the normal of a plane's point");
  table.number("planes.cluster_distance", p.cluster_distance_m, "m", 0.005, 0.2, "proximity of points of one surface");
  table.number("planes.min_area", p.min_area_m2, "m2", 0.001, 10.0, "of a plane");
}

}  // namespace amiss::segment
