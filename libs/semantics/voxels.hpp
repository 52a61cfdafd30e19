// A cloud thinned to voxels: what the forest looks at.
// in: cloud in the map frame [m]     out: one entry for each voxel with a point in it, in the order of first points:
// means of position, colour (CIE L*a*b* / 100) and normal; for each point its voxel
#pragma once

#include <cstdint>
#include <vector>

#include "core/frames.hpp"
#include "semantics/internal/cell_index.hpp"

namespace amiss::semantics {

struct Voxels {
  static constexpr std::uint32_t kNone = CellIndex::kNone;

  double edge_m = 0.02;
  std::vector<Eigen::Vector3i> cells;
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> colours;  // zero where the cloud has none
  std::vector<Eigen::Vector3f> normals;  // unit vectors; zero where the cloud has none or they cancel
  std::vector<std::uint32_t> of_point;   // kNone for points that are not finite
  CellIndex index;

  [[nodiscard]] std::size_t size() const { return cells.size(); }
  [[nodiscard]] std::uint32_t at(const Eigen::Vector3i& cell) const { return index.at(cell_key(cell)); }
};

[[nodiscard]] Voxels voxels_of(const Cloud<Map>& cloud, double edge_m);

/// sRGB -> CIE L*a*b* (D65), each divided by 100.
[[nodiscard]] Eigen::Vector3f lab_of(const Rgb& colour);

}  // namespace amiss::semantics
