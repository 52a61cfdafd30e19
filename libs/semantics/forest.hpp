// A random forest (Breiman 2001) as it is used and kept: trees of thresholds, at each leaf the classes that samples
// which came there had.
// in: kFeatureCount numbers of a voxel     out: a probability for each class of the forest, the mean of its trees
// A file holds the forest, the size of voxels it was trained on, and a hash of both. Errors: InputError that names the
// file and what is wrong with it; a file that is not broken never leads outside of the forest.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/semantic_class.hpp"

namespace amiss::semantics {

struct ForestNode {
  static constexpr std::uint8_t kLeaf = 255;
  struct Share {
    std::uint8_t place = 0;   // in Forest::classes
    std::uint8_t weight = 0;  // 255 is all
  };

  std::uint8_t feature = kLeaf;
  float threshold = 0;            // not above: the next node of the tree; above: the node `right`
  std::uint16_t right = 0;        // in the same tree
  std::array<Share, 3> shares{};  // of a leaf
};

struct Forest {
  double voxel_m = 0.02;
  std::vector<SemanticClass> classes;
  std::vector<std::vector<ForestNode>> trees;  // each with its root first

  /// Adds up to probabilities that are as many as classes.
  void classify(std::span<const float> features, std::span<float> probabilities) const;
};

[[nodiscard]] std::string forest_bytes(const Forest& forest);
[[nodiscard]] Forest parse_forest(std::string_view bytes, const std::string& name);
[[nodiscard]] Forest load_forest(const std::filesystem::path& file);
void save_forest(const std::filesystem::path& file, const Forest& forest);

}  // namespace amiss::semantics
