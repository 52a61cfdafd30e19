// Samples of voxels with their classes -> a forest (OpenCV's ml::RTrees, one tree at a time).
// Each tree sees its own draw of samples, in which rare classes are drawn more often than they are there: a class of n
// samples weighs sqrt(n). What its leaves say is counted over all samples, with the same weights.
// The same samples and seed give the same forest for any number of threads. Errors: ArgumentError where there are no
// samples or only one class, or where features do not fit.
#pragma once

#include <cstdint>

#include "semantics/forest.hpp"

namespace amiss::semantics {

struct ForestSamples {
  std::vector<float> features;  // kFeatureCount for each sample
  std::vector<SemanticClass> classes;
};

struct ForestTrainingParams {
  int trees = 30;
  int draws = 25000;             // samples that a tree sees
  int depth = 20;                // at most, 24 is the most that is allowed
  int fewest_in_node = 6;        // draws, below which a node is not split
  int features_of_a_split = 24;  // that it may choose from
};

[[nodiscard]] Forest train_forest(const ForestSamples& samples, const ForestTrainingParams& params, double voxel_m,
                                  std::uint64_t seed, int threads);

}  // namespace amiss::semantics
