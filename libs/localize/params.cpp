#include "core/params.hpp"

#include "localize/laser_mapper.hpp"
#include "localize/localizer.hpp"

namespace amiss::localize {

void describe(ParamTable& table, LocalizerParams& p) {
  table.integer("localize.particles", p.particles, 20, 5000, "particles of the filter");
  table.integer("localize.beams", p.beams, 10, 1000, "beams of a scan that the filter weighs");
  table.number("localize.hit_sigma", p.hit_sigma_m, "m", 0.01, 0.5, "width of the likelihood field");
  table.number("localize.hit_weight", p.hit_weight, "1", 0.1, 0.99, "part of the beams that end at a mapped thing");
  table.number("localize.odometry_xy_per_m", p.odometry_xy_per_m, "m/m", 0.0, 1.0, "odometry noise of a metre driven");
  table.number("localize.odometry_yaw_per_rad", p.odometry_yaw_per_rad, "rad/rad", 0.0, 1.0,
               "odometry noise of a radian turned");
  table.number("localize.odometry_yaw_per_m", p.odometry_yaw_per_m_rad, "rad/m", 0.0, 1.0,
               "turn by mistake in a metre driven");
  table.number("localize.max_spread", p.max_spread_m, "m", 0.01, 2.0, "spread of particles that count as converged");
  table.number("localize.min_fit", p.min_fit, "1", 0.0, 1.0, "part of the beams that fit a converged pose");
  table.number("localize.fit_distance", p.fit_distance_m, "m", 0.02, 0.5, "distance to a wall of beams that fit");
  table.number("localize.sure_fit", p.sure_fit, "1", 0.0, 1.0,
               "part of the beams below which the whole map is searched for a better pose");
  table.number("localize.max_correction", p.max_correction_m, "m", 0.005, 1.0, "of one scan, of a converged pose");
  table.number("localize.max_correction_yaw", p.max_correction_rad, "deg", 0.1, 45.0, "the same, turned");
  table.flag("localize.relocalize", p.relocalize, "search the whole map where scans and map disagree");
  table.flag("localize.refine", p.refine, "Gauss-Newton on the distance field after the filter");
}

void describe(ParamTable& table, LaserMapperParams& p) {
  table.number("laser_mapper.resolution", p.resolution_m, "m", 0.01, 0.2, "edge of a cell of the floor grid");
  table.number("laser_mapper.key_distance", p.key_distance_m, "m", 0.05, 2.0, "driven between two scans that are kept");
  table.number("laser_mapper.key_angle", p.key_angle_rad, "deg", 1.0, 90.0, "turned between two scans that are kept");
  table.number("laser_mapper.point_distance", p.point_distance_m, "m", 0.005, 0.2,
               "between two points of the point map");
  table.number("laser_mapper.min_goodness", p.min_goodness, "1", 0.0, 1.0,
               "part of the points that ICP must match to be believed");
  table.number("laser_mapper.max_range", p.max_range_m, "m", 1.0, 60.0, "of the beams that free the grid");
}

}  // namespace amiss::localize
