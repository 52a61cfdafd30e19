// What a depth image says of the voxels before the camera: the kernel of VoxelMap::insert.
//
// End points are counted pixel by pixel; free space is found block by block: the pyramid tells whether all rays through
// a block end behind it (all missed) or before it (nothing), and only where neither holds each voxel's centre is
// projected into the image. The result is the same as projecting every voxel.
#pragma once

#include <vector>

#include "mapping/internal/depth_pyramid.hpp"
#include "mapping/internal/end_points.hpp"

namespace amiss::mapping {

class DepthEvidence {
 public:
  enum class Search { kPyramid, kEveryVoxel };  // the second is the slow oracle of the first

  /// Blocks with a hit or a miss, in order of z, y, x. Valid until the next call.
  const std::vector<BlockEvidence>& look(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera,
                                         const VoxelMapParams& params, Search search = Search::kPyramid);

 private:
  enum class Verdict { kNothing, kAllMissed, kMixed };
  [[nodiscard]] Verdict judge(const Eigen::Vector3f& corner_local) const;
  void add_block(int x, int y, int z, const VoxelMapParams& params, Search search);

  Frustum frustum_;
  DepthPyramid pyramid_;
  EndPoints end_points_;
  std::vector<BlockEvidence> evidence_;
};

}  // namespace amiss::mapping
