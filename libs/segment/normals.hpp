// Unit normals of a cloud's points by principal components of their neighbours, turned upwards (z >= 0).
// in: points [m], radius of the neighbourhood [m]. out: one normal for each point; zero where fewer than 5 neighbours
// or a line of them do not tell.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "segment/point_grid.hpp"

namespace amiss::segment {

[[nodiscard]] std::vector<Eigen::Vector3f> upward_normals(const std::vector<Eigen::Vector3f>& points,
                                                          const PointGrid& grid, float radius_m);

}  // namespace amiss::segment
