// Where frames said which class is: votes of labelled pixels in voxels of the map (thesis 5.2.1, labels of images in a
// reconstruction).
// in: depth [m] and a class for each pixel of a camera, T_map_camera     out: the class with most votes at a point,
// from the voxel around it and, with less weight, its 26 neighbours; of equal ones the lower class number;
// kUnlabelled where nobody voted.
// Errors: InputError for images of sizes that do not fit or a pose that is not finite; the votes are then as they were.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/semantic_class.hpp"
#include "core/sensors.hpp"

namespace amiss::semantics {

struct VoteParams {
  double voxel_m = 0.02;
  double max_range_m = 3.0;  // of depth that votes
  int stride_px = 2;         // every second row and column votes
};

class ClassVotes {
 public:
  explicit ClassVotes(const VoteParams& params = {});

  void add(const RgbdFrame& frame, std::span<const SemanticClass> classes, const Transform<Map, Camera>& T_map_camera);
  void add(const Eigen::Vector3f& p_map, SemanticClass value);
  [[nodiscard]] SemanticClass at(const Eigen::Vector3f& p_map) const;
  [[nodiscard]] std::size_t voxels() const { return counts_.size(); }

 private:
  using Counts = std::array<std::uint16_t, kSemanticClasses.size()>;

  VoteParams params_;
  std::unordered_map<std::uint64_t, Counts> counts_;
};

}  // namespace amiss::semantics
