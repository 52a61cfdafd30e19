// All parameters of the thinking part of a run, each declared by the stage that it serves.
#pragma once

#include "change/difference.hpp"
#include "change/region.hpp"
#include "knowledge/knowledge_base.hpp"
#include "localize/laser_mapper.hpp"
#include "localize/localizer.hpp"
#include "mapping/voxel_map.hpp"
#include "mission/navigator.hpp"
#include "mission/perception.hpp"
#include "segment/segment.hpp"
#include "view/frontier.hpp"
#include "view/view_pose.hpp"
#include "view/view_triangle.hpp"

namespace amiss::mission {

struct SearchParams {
  double compare_s = 0.5;         // between two comparisons with the reference while driving
  double look_s = 0.4;            // of standing at a view triangle
  double settle_s = 0.4;          // of standing before a region is segmented, so that the frame is of now
  double segment_region_s = 1.0;  // simulated cost of segmenting a cropped frame (the thesis' simulation)
  double segment_frame_s = 6.0;   // and of a whole one, by the static method
  int viewpoints = 3;             // of one region that are tried
  int max_replans = 400;          // the guard against going round in circles
  double fine_gain_m2 = 0.08;     // of a view triangle, once the large ones are used up
  double explored_at = 0.995;     // part of the reachable floor seen that counts as explored
};
void describe(ParamTable& table, SearchParams& p);

struct MappingRunParams {
  int max_goals = 200;           // frontiers and view triangles, together
  double coverage_goal = 0.985;  // of the floor by view triangles
  double sweep_pan_rad = radians(55.0);
  double sweep_high_tilt_rad = radians(-12.0);
  double sweep_low_tilt_rad = radians(-38.0);
  int speckle_voxels = 1;   // groups of so few occupied voxels are spurious
  int dilation_voxels = 1;  // of the reference, in x and y
};
void describe(ParamTable& table, MappingRunParams& p);

struct Params {
  localize::LocalizerParams localizer;
  localize::LaserMapperParams laser_mapper;
  mapping::VoxelMapParams voxels;
  PerceptionParams perception;
  NavigationParams navigation;
  change::DifferenceParams difference;
  change::RegionParams region;
  knowledge::Params knowledge;
  view::TriangleParams triangle;
  view::PoseParams view_pose;
  view::FrontierParams frontier;
  segment::Params segment;
  SearchParams search;
  MappingRunParams mapping_run;
};
void describe(ParamTable& table, Params& p);

}  // namespace amiss::mission
