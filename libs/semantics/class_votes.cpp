#include "semantics/class_votes.hpp"

#include <limits>
#include <string>

#include "core/result.hpp"
#include "semantics/class_index.hpp"
#include "semantics/internal/cells.hpp"

namespace amiss::semantics {

namespace {

/// Of a neighbour by the number of axes that it differs in.
constexpr std::array<std::uint32_t, 4> kWeights{8, 4, 2, 1};

void check(const RgbdFrame& frame, std::span<const SemanticClass> classes, const Transform<Map, Camera>& T_map_camera) {
  const std::size_t pixels =
      static_cast<std::size_t>(frame.intrinsics.width) * static_cast<std::size_t>(frame.intrinsics.height);
  if (frame.depth_m.size() != pixels || classes.size() != pixels) {
    throw InputError("votes of a frame: " + std::to_string(frame.depth_m.size()) + " depths and " +
                     std::to_string(classes.size()) + " classes; " + std::to_string(pixels) + " of each are needed");
  }
  if (!T_map_camera.T.matrix().allFinite()) throw InputError("votes of a frame: its pose is not finite");
}

}  // namespace

ClassVotes::ClassVotes(const VoteParams& params) : params_(params) {
  if (!(params.voxel_m >= 0.002) || !(params.max_range_m > 0) || params.stride_px < 1) {
    throw ArgumentError("votes: voxels of 0.002 m or more, a range above 0 and a stride of 1 or more are allowed");
  }
}

void ClassVotes::add(const RgbdFrame& frame, std::span<const SemanticClass> classes,
                     const Transform<Map, Camera>& T_map_camera) {
  check(frame, classes, T_map_camera);
  const CameraIntrinsics& k = frame.intrinsics;
  for (int v = 0; v < k.height; v += params_.stride_px) {
    for (int u = 0; u < k.width; u += params_.stride_px) {
      const std::size_t i =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(k.width) + static_cast<std::size_t>(u);
      const double z = static_cast<double>(frame.depth_m[i]);
      if (!(z > 0 && z <= params_.max_range_m)) continue;
      const Eigen::Vector3d p_camera((u - k.cx) / k.fx * z, (v - k.cy) / k.fy * z, z);
      add((T_map_camera.T * p_camera).cast<float>(), classes[i]);
    }
  }
}

void ClassVotes::add(const Eigen::Vector3f& p_map, SemanticClass value) {
  if (!is_near(p_map) || value == SemanticClass::kUnlabelled) return;
  std::uint16_t& count = counts_[cell_key(cell_of(p_map, params_.voxel_m))][index_of(value)];
  if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
}

SemanticClass ClassVotes::at(const Eigen::Vector3f& p_map) const {
  if (!is_near(p_map)) return SemanticClass::kUnlabelled;
  const Eigen::Vector3i cell = cell_of(p_map, params_.voxel_m);
  std::array<std::uint32_t, kSemanticClasses.size()> sums{};
  for_neighbours([&](const Eigen::Vector3i& offset) {
    const auto found = counts_.find(cell_key(cell + offset));
    if (found == counts_.end()) return;
    const std::uint32_t weight = kWeights[static_cast<std::size_t>(offset.cwiseAbs().sum())];
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += weight * found->second[c];
  });
  std::size_t best = 0;  // kUnlabelled never has votes
  for (std::size_t c = 1; c < sums.size(); ++c) {
    if (sums[c] > sums[best]) best = c;
  }
  return kSemanticClasses[best].value;
}

}  // namespace amiss::semantics
