#include "mission/params.hpp"

namespace amiss::mission {

void describe(ParamTable& table, SearchParams& p) {
  table.number("search.compare", p.compare_s, "s", 0.02, 60.0, "between two comparisons with the reference");
  table.number("search.look", p.look_s, "s", 0.2, 10.0, "of standing at a view triangle");
  table.number("search.settle", p.settle_s, "s", 0.2, 10.0, "of standing before a region is segmented");
  table.number("search.segment_region", p.segment_region_s, "s", 0.0, 60.0,
               "simulated cost of segmenting a cropped frame");
  table.number("search.segment_frame", p.segment_frame_s, "s", 0.0, 60.0, "simulated cost of segmenting a whole frame");
  table.integer("search.viewpoints", p.viewpoints, 1, 12, "of one region that are tried");
  table.integer("search.max_replans", p.max_replans, 1, 100000, "guard against going round in circles");
  table.number("search.fine_gain", p.fine_gain_m2, "m2", 0.01, 1.0,
               "of a view triangle once the large ones are used up");
  table.number("search.explored_at", p.explored_at, "", 0.1, 1.0,
               "part of the reachable floor that counts as explored");
}

void describe(ParamTable& table, MappingRunParams& p) {
  table.integer("map.max_goals", p.max_goals, 1, 10000, "frontiers and view triangles that are driven to");
  table.number("map.coverage_goal", p.coverage_goal, "", 0.1, 1.0, "part of the floor that view triangles must cover");
  table.number("map.sweep_pan", p.sweep_pan_rad, "deg", 0.0, 100.0, "pan of the head to both sides");
  table.number("map.sweep_high_tilt", p.sweep_high_tilt_rad, "deg", -60.0, 20.0, "upper tilt of a sweep");
  table.number("map.sweep_low_tilt", p.sweep_low_tilt_rad, "deg", -80.0, 0.0, "lower tilt of a sweep");
  table.integer("map.speckle_voxels", p.speckle_voxels, 0, 100, "groups of so few occupied voxels are spurious");
  table.integer("map.dilation_voxels", p.dilation_voxels, 0, 5, "dilation of the reference in x and y");
}

void describe(ParamTable& table, Params& p) {
  localize::describe(table, p.localizer);
  localize::describe(table, p.laser_mapper);
  mapping::describe(table, p.voxels);
  describe(table, p.perception);
  describe(table, p.navigation);
  change::describe(table, p.difference);
  change::describe(table, p.region);
  knowledge::describe(table, p.knowledge);
  view::describe(table, p.triangle);
  view::describe(table, p.view_pose);
  view::describe(table, p.frontier);
  segment::describe(table, p.segment);
  describe(table, p.search);
  describe(table, p.mapping_run);
}

}  // namespace amiss::mission
