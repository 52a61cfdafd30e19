#include "mapping/reconstructor.hpp"

#include "core/result.hpp"
#include "mapping/seen_space.hpp"
#include "mapping/surface_mesh.hpp"
#include "mapping/voxel_colours.hpp"

namespace amiss::mapping {
namespace {

class TsdfReconstructor : public Reconstructor {
 public:
  explicit TsdfReconstructor(const ReconstructionParams& params) : params_(params), map_(params.surface) {}

  std::optional<Refinement> refine(const RgbdFrame& frame, const Transform<Map, Camera>& expected) override {
    if (!params_.refine) return std::nullopt;
    // Localization errs slowly: what was wrong with the last frame is likely to be wrong with this one.
    const Transform<Map, Camera> start{correction_ * expected.T};
    Refinement refinement = refine_pose(map_, frame, expected, start, params_.refinement);
    correction_ = refinement.T_map_camera.T * expected.T.inverse();
    return refinement;
  }
  void insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera) override {
    map_.insert(frame, T_map_camera);
  }
  [[nodiscard]] Reconstruction finish() const override {
    TriangleMesh<Map> mesh = surface_mesh(map_, params_.min_weight);
    Cloud<Map> cloud = surface_cloud(mesh, params_.surface.voxel_m);
    return {std::move(cloud), std::move(mesh),
            seen_space(map_.values(), params_.surface.voxel_m, params_.space_voxels)};
  }

 private:
  ReconstructionParams params_;
  SurfaceMap map_;
  Eigen::Isometry3d correction_ = Eigen::Isometry3d::Identity();  // map from map, of the last refinement
};

VoxelMapParams voxels_of(const SurfaceParams& p) {
  VoxelMapParams voxels;
  voxels.resolution_m = p.voxel_m;
  voxels.min_range_m = p.min_range_m;
  voxels.max_range_m = voxels.max_hit_range_m = p.max_range_m;
  return voxels;
}

class OccupancyReconstructor : public Reconstructor {
 public:
  explicit OccupancyReconstructor(const ReconstructionParams& params)
      : params_(params),
        map_(voxels_of(params.surface)),
        colours_(params.surface.voxel_m, params.surface.min_range_m, params.surface.max_range_m) {}

  std::optional<Refinement> refine(const RgbdFrame& /*frame*/, const Transform<Map, Camera>& /*expected*/) override {
    return std::nullopt;
  }
  void insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera) override {
    colours_.insert(frame, T_map_camera);
    map_.insert(frame, T_map_camera);
  }
  [[nodiscard]] Reconstruction finish() const override {
    return {occupied_cloud(map_, colours_), {}, seen_space(map_.values(), map_.resolution_m(), params_.space_voxels)};
  }

 private:
  ReconstructionParams params_;
  VoxelMap map_;
  VoxelColours colours_;
};

}  // namespace

void describe(ParamTable& table, ReconstructionParams& p) {
  table.choice("reconstruct.method", p.method, {"tsdf", "octomap"}, "what the room is made of");
  table.flag("reconstruct.refine", p.refine, "refine poses against the model by ICP (tsdf only; 5.3.2.1)");
  table.number("reconstruct.min_weight", p.min_weight, "1/m2", 0, 1e6, "surface that weighs less is left out");
  table.integer("reconstruct.space", p.space_voxels, 1, 8,
                "voxels along an edge of those of the seen space: 1, 2, 4, 8");
  describe(table, p.surface);
  describe(table, p.refinement);
}

std::unique_ptr<Reconstructor> make_reconstructor(const ReconstructionParams& params) {
  const int edge = params.space_voxels;
  if (edge != 1 && edge != 2 && edge != 4 && edge != 8) {
    throw ArgumentError("reconstruct.space: allowed are 1, 2, 4 and 8 voxels");
  }
  if (params.method == "tsdf") return std::make_unique<TsdfReconstructor>(params);
  if (params.method != "octomap") {
    throw ArgumentError("reconstruct.method: '" + params.method + "' is not allowed; allowed are tsdf and octomap");
  }
  if (params.refine) throw ArgumentError("reconstruct.refine: poses are refined with reconstruct.method tsdf only");
  return std::make_unique<OccupancyReconstructor>(params);
}

}  // namespace amiss::mapping
