// Horizontal surfaces on which objects may lie (Section 5.2.1): points of relevant classes with steep normals are
// clustered, and RANSAC with a horizontal model is run in every cluster until what is left is too small.
// in: points [m], their normals (z >= 0, zero where unknown), labels (empty: all points are relevant). out: planes by
// ascending height at their middle, with inliers (ascending) and footprints. Repeatable: the random stream is passed
// in.
#pragma once

#include "core/params.hpp"
#include "core/random.hpp"
#include "segment/clusters.hpp"
#include "segment/footprint.hpp"
#include "segment/relevant_classes.hpp"
#include "segment/segment.hpp"

namespace amiss::segment {

struct SupportPlaneParams {
  double distance_m = 0.01;                    // tau_r_dist of Table 5.1
  double max_tilt_rad = radians(5.0);          // tau_r_angle of Table 5.1
  double max_normal_tilt_rad = radians(25.0);  // of a point's normal: noise of a reconstruction
  double cluster_distance_m = 0.03;
  double min_area_m2 = 0.01;
};
void describe(ParamTable& table, SupportPlaneParams& p);

struct SupportPlane {
  Plane plane;
  Indices inliers;
  Footprint footprint;
  double area_m2 = 0.0;
  double height_m = 0.0;  // z at the mean of its inliers

  /// Height of a point above it, along the normal.
  [[nodiscard]] double above(const Eigen::Vector3f& p) const {
    return plane.normal_map.dot(p.cast<double>()) + plane.d_m;
  }
};

[[nodiscard]] std::vector<SupportPlane> support_planes(const std::vector<Eigen::Vector3f>& points,
                                                       const std::vector<Eigen::Vector3f>& normals,
                                                       const std::vector<SemanticClass>& labels,
                                                       const SupportPlaneParams& params, RandomStream random);

}  // namespace amiss::segment
