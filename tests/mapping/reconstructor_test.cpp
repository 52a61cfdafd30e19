#include "mapping/reconstructor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/result.hpp"
#include "mapping/surface_scene.hpp"

namespace amiss::mapping {
namespace {

ReconstructionParams params_of(const std::string& method) {
  ReconstructionParams params;
  params.method = method;
  params.surface.voxel_m = 0.04;
  params.refinement.pixel_step = 2;
  return params;
}

Reconstruction reconstruction_of(const ReconstructionParams& params, const SurfaceRecording& r) {
  const auto reconstructor = make_reconstructor(params);
  for (std::size_t i = 0; i < r.frames.size(); ++i) {
    const auto refined = i == 0 ? std::nullopt : reconstructor->refine(r.frames[i], r.poses[i]);
    reconstructor->insert(r.frames[i], refined ? refined->T_map_camera : r.poses[i]);
  }
  return reconstructor->finish();
}

/// Root mean square of the distances of the points to the scene, at most a voxel each.
double error_of(const Cloud<Map>& cloud) {
  double squares = 0.0;
  for (const Eigen::Vector3f& p : cloud.points) {
    squares += std::pow(std::min(std::abs(distance_to(surface_scene(), p.cast<double>())), 0.04), 2);
  }
  return std::sqrt(squares / static_cast<double>(cloud.points.size()));
}

TEST(Reconstructor, BothMethodsGiveTheRoom) {
  const SurfaceRecording r = surface_recording(4, true, small_camera());
  for (const char* method : {"tsdf", "octomap"}) {
    SCOPED_TRACE(method);
    const Reconstruction made = reconstruction_of(params_of(method), r);
    EXPECT_GT(made.cloud.points.size(), 1000U);
    EXPECT_EQ(made.cloud.colours.size(), made.cloud.points.size());
    EXPECT_EQ(made.cloud.normals.size(), made.cloud.points.size());
    EXPECT_LT(error_of(made.cloud), 0.016);
    EXPECT_EQ(made.mesh.triangles.empty(), std::string(method) == "octomap");
    EXPECT_DOUBLE_EQ(made.space.resolution_m(), 0.08);
    EXPECT_EQ(made.space.at(Eigen::Vector3d(0.7, 0.0, 0.5)), Occupancy::kFree);
    EXPECT_EQ(made.space.at(Eigen::Vector3d(1.5, -0.35, 0.2)), Occupancy::kUnknown) << "inside a box";
  }
}

TEST(Reconstructor, RefinedPosesGiveASharperRoom) {
  SurfaceRecording r = surface_recording(8, true, small_camera());
  RandomStream random(3, "localization");
  const SurfaceRecording exact = r;
  for (std::size_t i = 1; i < r.poses.size(); ++i) {
    r.poses[i].T.translation() += Eigen::Vector3d(random.normal() * 0.02, random.normal() * 0.02, 0.0);
    r.poses[i].T.linear() =
        Eigen::AngleAxisd(random.normal() * 0.015, Eigen::Vector3d::UnitZ()).toRotationMatrix() * r.poses[i].T.linear();
  }
  ReconstructionParams params = params_of("tsdf");
  const double rough_m = error_of(reconstruction_of(params, r).cloud);
  const double best_m = error_of(reconstruction_of(params, exact).cloud);
  params.refine = true;
  const double refined_m = error_of(reconstruction_of(params, r).cloud);
  EXPECT_LT(refined_m, 0.5 * (rough_m + best_m)) << rough_m << " without, " << best_m << " at best";
}

TEST(Reconstructor, PosesAreRefinedOnlyWhenWanted) {
  const SurfaceRecording r = surface_recording(1, true, small_camera());
  for (const char* method : {"tsdf", "octomap"}) {
    EXPECT_FALSE(make_reconstructor(params_of(method))->refine(r.frames[0], r.poses[0]));
  }
}

TEST(Reconstructor, RefusesWrongParameters) {
  ReconstructionParams params = params_of("voxels");
  EXPECT_THROW((void)make_reconstructor(params), ArgumentError);
  params = params_of("octomap");
  params.refine = true;
  EXPECT_THROW((void)make_reconstructor(params), ArgumentError);
  params = params_of("tsdf");
  params.space_voxels = 3;
  EXPECT_THROW((void)make_reconstructor(params), ArgumentError);
  params.space_voxels = 2;
  params.surface.voxel_m = -1.0;
  EXPECT_THROW((void)make_reconstructor(params), ArgumentError);
}

TEST(Reconstructor, OfNothingIsEmpty) {
  const Reconstruction made = make_reconstructor(params_of("tsdf"))->finish();
  EXPECT_TRUE(made.cloud.points.empty());
  EXPECT_EQ(made.space.counts(), VoxelCounts{});
}

}  // namespace
}  // namespace amiss::mapping
