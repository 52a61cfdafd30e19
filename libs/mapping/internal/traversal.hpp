// The voxels that a segment crosses, in order (Amanatides and Woo 1987). Coordinates in voxels.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "mapping/voxel_blocks.hpp"

namespace amiss::mapping {

/// Calls visit(Voxel) from the voxel of `a` to that of `b`, both included, until it returns false.
template <class Visit>
void traverse(const Eigen::Vector3d& a, const Eigen::Vector3d& b, Visit visit) {
  Eigen::Vector3i at = a.array().floor().cast<int>();
  const Eigen::Vector3i end = b.array().floor().cast<int>();
  const Eigen::Vector3d along = b - a;
  Eigen::Vector3i step;
  Eigen::Vector3d next, each;  // as fractions of the segment
  for (int i = 0; i < 3; ++i) {
    step[i] = along[i] > 0.0 ? 1 : -1;
    const bool moves = at[i] != end[i];
    each[i] = moves ? std::abs(1.0 / along[i]) : std::numeric_limits<double>::infinity();
    const double border = at[i] + (step[i] > 0 ? 1 : 0);
    next[i] = moves ? (border - a[i]) / along[i] : std::numeric_limits<double>::infinity();
  }
  for (int left = (end - at).cwiseAbs().sum();; --left) {
    if (!visit(Voxel{at.x(), at.y(), at.z()}) || left == 0) return;
    int axis = next.x() <= next.y() ? 0 : 1;
    if (next.z() < next[axis]) axis = 2;
    at[axis] += step[axis];
    next[axis] = at[axis] == end[axis] ? std::numeric_limits<double>::infinity() : next[axis] + each[axis];
  }
}

}  // namespace amiss::mapping
