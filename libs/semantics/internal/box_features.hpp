// How much surface is in boxes around a voxel.
// in: voxels with normals     out: kCount numbers for a voxel: parts of the boxes' floor plans that hold surface
#pragma once

#include "semantics/internal/summed_volume.hpp"
#include "semantics/voxels.hpp"

namespace amiss::semantics {

class BoxFeatures {
 public:
  static constexpr std::size_t kCount = 119;

  explicit BoxFeatures(const Voxels& voxels);

  /// Writes the numbers of a voxel; returns where the next one goes. Threads may share it.
  float* put(std::size_t voxel, float* out) const;

 private:
  [[nodiscard]] Eigen::Vector3i box_cell_of(std::size_t voxel) const;
  void find_supports();
  [[nodiscard]] std::size_t place(const Eigen::Vector3i& cell) const;
  [[nodiscard]] int level_around(const Eigen::Vector3i& cell, int half_width) const;
  float* put_support(const Eigen::Vector3i& cell, float z_m, float* out) const;

  const Voxels& voxels_;
  Eigen::Vector3i low_;                 // the first voxel in x and y; z is that of the lowest layer
  SummedVolume surface_, level_;        // cells of 2 x 2 x 1 voxels; level: with normals that point up
  std::vector<std::int16_t> supports_;  // for each cell the layer of the level surface below it, -1 for none
};

}  // namespace amiss::semantics
