// Shape and colour of what lies around a voxel, at one scale.
// in: voxels, edge of the cells     out: for each voxel the moments of all voxels in the 27 cells around its own
#pragma once

#include <vector>

#include "semantics/voxels.hpp"

namespace amiss::semantics {

struct Surrounding {
  float voxels = 0;  // how many
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();    // of the plane that fits best, either sign
  Eigen::Vector3f variances = Eigen::Vector3f::Zero();  // along the main axes, smallest first [m2]
  float variance_z = 0;
  Eigen::Vector3f colour = Eigen::Vector3f::Zero();
  Eigen::Vector3f colour_deviation = Eigen::Vector3f::Zero();
};

struct Surroundings {
  std::vector<std::uint32_t> of_voxel;
  std::vector<Surrounding> cells;

  [[nodiscard]] const Surrounding& at(std::size_t voxel) const { return cells[of_voxel[voxel]]; }
};

[[nodiscard]] Surroundings surroundings_of(const Voxels& voxels, double cell_m, int threads);

}  // namespace amiss::semantics
