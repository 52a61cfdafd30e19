// Neighbours agree: probabilities of voxels, drawn towards those of the voxels beside them.
// in: voxels, probabilities (as many for each voxel)     out: the same, smoothed; rows still add up to one
// A neighbour (of 26) counts as much as its colour and its normal are alike, so that edges stay edges.
#pragma once

#include <vector>

#include "semantics/voxels.hpp"

namespace amiss::semantics {

struct SmoothingParams {
  int rounds = 4;
  double strength = 0.7;       // of the neighbours against what the voxel itself says
  double colour_scale = 0.08;  // of CIE Lab / 100
};

[[nodiscard]] std::vector<float> smoothed(const Voxels& voxels, const std::vector<float>& probabilities,
                                          const SmoothingParams& params, int threads);

}  // namespace amiss::semantics
