// How many depth pixels of a frame end in each voxel, and which voxels that makes hit.
#pragma once

#include <vector>

#include "mapping/internal/evidence.hpp"
#include "mapping/internal/frustum.hpp"

namespace amiss::mapping {

class EndPoints {
 public:
  void count(const RgbdFrame& frame, const Frustum& frustum, const VoxelMapParams& params);

  /// Voxels with enough end points, and those with some but too few to tell (half of enough), which are neither hit
  /// nor missed. `block` is a block's index in the frustum.
  struct Verdict {
    BlockBits hit{}, doubtful{};
  };
  [[nodiscard]] bool any(std::size_t block) const { return directory_[block] >= 0; }
  [[nodiscard]] Verdict verdict(std::size_t block, const Eigen::Vector3f& corner_local, const Frustum& frustum,
                                const VoxelMapParams& params) const;

 private:
  void scatter();

  std::vector<std::int32_t> directory_;  // frustum block -> slot or -1
  std::vector<std::uint16_t> counts_;    // 512 for each slot
  std::int32_t slots_ = 0;
  std::vector<std::int32_t> row_;  // 512 * block + voxel in block, or -1, for a row of pixels
  std::vector<float> packed_;
};

}  // namespace amiss::mapping
