#include "mapping/surface_icp.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/result.hpp"
#include "mapping/surface_scene.hpp"

namespace amiss::mapping {
namespace {

/// The furnished corner, seen from several places, and one more frame of it.
struct Model {
  SurfaceMap map;
  RgbdFrame frame;
  Transform<Map, Camera> pose;
};
const Model& model() {
  static const Model made = [] {
    SurfaceParams params;
    params.voxel_m = 0.02;
    Model m{SurfaceMap(params), {}, camera_pose(0.05, 0.0, 0.25, -0.55)};
    CameraIntrinsics half = small_camera();
    const SurfaceRecording r = surface_recording(6, true, half);
    for (std::size_t i = 0; i < r.frames.size(); ++i) m.map.insert(r.frames[i], r.poses[i]);
    RandomStream random(7, "frame");
    m.frame = noisy_frame(exact_frame(surface_scene(), m.pose, half), random);
    return m;
  }();
  return made;
}

RefinementParams params_of(bool planar) {
  RefinementParams params;
  params.planar = planar;
  params.pixel_step = 2;  // of a quarter of the pixels
  params.expected_shift_m = 0.03;
  params.expected_turn_rad = radians(1.0);
  return params;
}

Transform<Map, Camera> perturbed(const Transform<Map, Camera>& T, const Eigen::Vector3d& shift,
                                 const Eigen::Vector3d& turn) {
  Transform<Map, Camera> result = T;
  result.T.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * T.T.linear();
  result.T.translation() += shift;
  return result;
}
double shift_between(const Transform<Map, Camera>& a, const Transform<Map, Camera>& b) {
  return (a.position() - b.position()).norm();
}
double turn_between(const Transform<Map, Camera>& a, const Transform<Map, Camera>& b) {
  return Eigen::AngleAxisd(a.T.linear().transpose() * b.T.linear()).angle();
}

RC_GTEST_PROP(SurfaceIcp, FindsThePoseOfARobotThatIsOffByCentimetres, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 10000)), "planar");
  const double heading = random.uniform(-3.14, 3.14);
  const Eigen::Vector3d shift = random.uniform(0.0, 0.04) * Eigen::Vector3d(std::cos(heading), std::sin(heading), 0.0);
  const auto expected =
      perturbed(model().pose, shift, random.uniform(-1.0, 1.0) * radians(1.5) * Eigen::Vector3d::UnitZ());
  const Refinement r = refine_pose(model().map, model().frame, expected, expected, params_of(true));
  RC_ASSERT(r.accepted);
  RC_ASSERT(shift_between(r.T_map_camera, model().pose) < 0.006);
  RC_ASSERT(turn_between(r.T_map_camera, model().pose) < radians(0.3));
  RC_ASSERT(std::abs(r.T_map_camera.position().z() - expected.position().z()) < 1e-9);
  RC_ASSERT(r.overlap() > 0.5);
}

RC_GTEST_PROP(SurfaceIcp, FindsAllSixNumbersOfACameraInTheHand, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 10000)), "hand");
  const auto off = [&](double most) {
    return Eigen::Vector3d(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
  };
  const auto expected = perturbed(model().pose, off(0.02), off(radians(0.8)));
  const Refinement r = refine_pose(model().map, model().frame, expected, expected, params_of(false));
  RC_ASSERT(r.accepted);
  RC_ASSERT(shift_between(r.T_map_camera, model().pose) < 0.008);
  RC_ASSERT(turn_between(r.T_map_camera, model().pose) < radians(0.4));
}

TEST(SurfaceIcp, StaysWhereThePoseIsRight) {
  const Refinement r = refine_pose(model().map, model().frame, model().pose, model().pose, params_of(true));
  EXPECT_LT(r.shift_m, 0.005);
  EXPECT_LT(r.turn_rad, radians(0.3));
}

TEST(SurfaceIcp, RefusesAPoseThatIsWrong) {
  for (const auto& wrong :
       {perturbed(model().pose, {0.3, -0.25, 0}, {0, 0, 1e-9}), perturbed(model().pose, {0, 0, 0}, {0, 0, 0.35}),
        perturbed(model().pose, {0, 0, 0.2}, {0.1, 0, 0}), perturbed(model().pose, {5, 0, 0}, {0, 0, 1e-9})}) {
    for (const bool planar : {true, false}) {
      const Refinement r = refine_pose(model().map, model().frame, wrong, wrong, params_of(planar));
      EXPECT_FALSE(r.accepted) << wrong.position().transpose();
      EXPECT_FALSE(r.why.empty());
      EXPECT_TRUE(r.T_map_camera.T.isApprox(wrong.T)) << "as it came";
    }
  }
}

/// Of a bare floor only height and tilt can be told; the rest must not run away (normals of the model are off by a
/// degree or two, so it moves by millimetres).
TEST(SurfaceIcp, KeepsWhatTheModelDoesNotHold) {
  TestScene floor;
  floor.floor_z_m = 0.0;
  const auto pose = camera_pose(0, 0, 0, -0.9);
  RgbdFrame frame = exact_frame(floor, pose, small_camera());
  paint(frame);
  SurfaceParams surface;
  surface.voxel_m = 0.02;
  SurfaceMap map(surface);
  map.insert(frame, pose);
  const auto expected = perturbed(pose, {0.01, -0.01, 0.01}, {0, 0, radians(0.5)});
  const Refinement r = refine_pose(map, frame, expected, expected, params_of(false));
  ASSERT_TRUE(r.accepted) << r.why;
  EXPECT_NEAR(r.T_map_camera.position().z(), pose.position().z(), 0.001);
  EXPECT_NEAR(r.T_map_camera.position().x(), 0.01, 0.01);
  EXPECT_NEAR(r.T_map_camera.position().y(), -0.01, 0.01);
}

TEST(SurfaceIcp, TheSearchMayBeginElsewhere) {
  const auto expected = perturbed(model().pose, {0.05, 0.03, 0}, {0, 0, 1e-9});
  const auto start = perturbed(model().pose, {0.004, 0.002, 0}, {0, 0, 1e-9});
  const Refinement r = refine_pose(model().map, model().frame, expected, start, params_of(true));
  ASSERT_TRUE(r.accepted) << r.why;
  EXPECT_LT(shift_between(r.T_map_camera, model().pose), 0.008);
  EXPECT_NEAR(r.shift_m, shift_between(r.T_map_camera, expected), 1e-9);
}

TEST(SurfaceIcp, NothingToFitIsRefused) {
  const Refinement r = refine_pose(SurfaceMap(), model().frame, model().pose, model().pose, params_of(true));
  EXPECT_FALSE(r.accepted);
  EXPECT_EQ(r.pairs, 0U);
}

TEST(SurfaceIcp, RefusesWrongParametersAndFrames) {
  const auto refuse = [](auto change) {
    RefinementParams params = params_of(true);
    change(params);
    EXPECT_THROW((void)refine_pose(model().map, model().frame, model().pose, model().pose, params), ArgumentError);
  };
  refuse([](RefinementParams& p) { p.pixel_step = 0; });
  refuse([](RefinementParams& p) { p.iterations = 0; });
  refuse([](RefinementParams& p) { p.expected_shift_m = 0.0; });
  refuse([](RefinementParams& p) { p.max_turn_rad = -1.0; });
  refuse([](RefinementParams& p) { p.min_overlap = 1.5; });
  refuse([](RefinementParams& p) { p.max_rms_voxels = 0.0; });
  RgbdFrame frame = model().frame;
  frame.depth_m.pop_back();
  EXPECT_THROW((void)refine_pose(model().map, frame, model().pose, model().pose, params_of(true)), InputError);
}

}  // namespace
}  // namespace amiss::mapping
