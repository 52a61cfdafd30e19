// A room as others want it, from frames with poses: points, triangles and the space that was seen (5.3.2.1, 5.3.6).
//
// in: RgbdFrame + T_map_camera, one after the other     out: Reconstruction
//
// Methods: "tsdf" (SurfaceMap; the pose of each frame may be refined against what the frames before it made) and
// "octomap" (VoxelMap with the colours of its voxels; no triangles). Errors: ArgumentError for wrong parameters,
// InputError for frames that cannot be used; what was made before is then as it was.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/triangle_mesh.hpp"
#include "mapping/surface_icp.hpp"
#include "mapping/surface_map.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

struct ReconstructionParams {
  std::string method = "tsdf";
  bool refine = false;
  double min_weight = 4.0;
  int space_voxels = 2;
  SurfaceParams surface;  // for both methods: edge of a voxel and ranges
  RefinementParams refinement;
};
void describe(ParamTable& table, ReconstructionParams& params);

struct Reconstruction {
  Cloud<Map> cloud;        // one point for each voxel of the surface, with colours and normals
  TriangleMesh<Map> mesh;  // tsdf only
  VoxelMap space;          // unknown, free, occupied, in voxels of space_voxels * voxel_m
};

class Reconstructor {
 public:
  virtual ~Reconstructor() = default;
  Reconstructor() = default;
  Reconstructor(const Reconstructor&) = delete;
  Reconstructor& operator=(const Reconstructor&) = delete;

  /// The pose against the model, before insert(); nothing when poses are not refined.
  [[nodiscard]] virtual std::optional<Refinement> refine(const RgbdFrame& frame,
                                                         const Transform<Map, Camera>& expected) = 0;
  virtual void insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera) = 0;
  [[nodiscard]] virtual Reconstruction finish() const = 0;
};

[[nodiscard]] std::unique_ptr<Reconstructor> make_reconstructor(const ReconstructionParams& params);

}  // namespace amiss::mapping
