#include "robot/model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace amiss::robot {
namespace {

constexpr const char* kOurs = AMISS_SOURCE_DIR "/robot_model/hsr.urdf";

const Model& ours() {
  static const Model model = load_model(kOurs);
  return model;
}

Eigen::Isometry3d pose_of(const std::string& link, const std::map<std::string, double>& positions) {
  const auto& links = ours().links;
  const auto found = std::find_if(links.begin(), links.end(), [&](const Link& l) { return l.name == link; });
  if (found == links.end()) throw std::runtime_error("no link " + link);
  return ours().link_poses(positions)[static_cast<std::size_t>(found - links.begin())];
}

void expect_near(const Eigen::Vector3d& actual, const Eigen::Vector3d& wanted, double tolerance) {
  EXPECT_LT((actual - wanted).cwiseAbs().maxCoeff(), tolerance)
      << actual.transpose() << " is not " << wanted.transpose();
}

TEST(HsrModelTest, CameraStandsWhereTheRobotHasIt) {
  expect_near(ours().T_base_camera({0.0, 0.0}).position(), {-0.060, 0.022, 0.967}, 6e-4);
  expect_near(ours().T_base_camera({0.0, -0.5}).position(), {0.053, 0.022, 0.979}, 6e-4);
  expect_near(ours().T_base_camera({0.0, -0.8}).position(), {0.119, 0.022, 0.959}, 6e-4);
  expect_near(pose_of("head_rgbd_sensor_rgb_frame", {{"arm_lift_joint", 0.69}}).translation(), {-0.060, 0.022, 1.312},
              6e-4);
}

TEST(HsrModelTest, CameraLooksForwardAndTiltsDown) {
  const Eigen::Matrix3d level = ours().T_base_camera({0.0, 0.0}).T.linear();
  expect_near(level.col(2), {1, 0, 0}, 1e-6);   // forward
  expect_near(level.col(0), {0, -1, 0}, 1e-6);  // right
  expect_near(level.col(1), {0, 0, -1}, 1e-6);  // down
  const Eigen::Vector3d down = ours().T_base_camera({0.0, -0.5}).T.linear().col(2);
  expect_near(down, {std::cos(0.5), 0, -std::sin(0.5)}, 1e-6);
  const Eigen::Vector3d left = ours().T_base_camera({0.7, 0.0}).T.linear().col(2);
  expect_near(left, {std::cos(0.7), std::sin(0.7), 0}, 1e-6);
}

TEST(HsrModelTest, HeadStopsAtItsLimits) {
  EXPECT_DOUBLE_EQ(ours().limits.pan_min_rad, -3.84);
  EXPECT_DOUBLE_EQ(ours().limits.pan_max_rad, 1.75);
  EXPECT_DOUBLE_EQ(ours().limits.tilt_min_rad, -1.57);
  EXPECT_DOUBLE_EQ(ours().limits.tilt_max_rad, 0.52);
  EXPECT_DOUBLE_EQ(ours().limits.head_rad_s, 1.0);
  EXPECT_TRUE(ours().T_base_camera({9.0, 9.0}).T.isApprox(ours().T_base_camera({1.75, 0.52}).T));
  EXPECT_TRUE(ours().T_base_camera({-9.0, -9.0}).T.isApprox(ours().T_base_camera({-3.84, -1.57}).T));
}

TEST(HsrModelTest, LaserAndArmAreWhereTheyShouldBe) {
  expect_near(ours().T_base_laser.position(), {0.1675, 0, 0.184}, 1e-9);
  expect_near(pose_of("arm_flex_link", {}).translation(), {0.141, 0.078, 0.340}, 1e-9);
  const std::map<std::string, double> reach = {
      {"arm_flex_joint", -1.5707963}, {"arm_roll_joint", 0}, {"wrist_flex_joint", 0}};
  EXPECT_NEAR(pose_of("hand_palm_link", reach).translation().x(), 0.627, 1e-3);
  EXPECT_NEAR(pose_of("hand_palm_link", reach).translation().z(), 0.323, 1e-3);
  std::map<std::string, double> high = reach;
  high["arm_lift_joint"] = 0.69;
  EXPECT_NEAR(pose_of("hand_palm_link", high).translation().z(), 1.013, 1e-3);
}

TEST(HsrModelTest, TorsoFollowsTheArmAtHalf) {
  EXPECT_NEAR(pose_of("torso_lift_link", {{"arm_lift_joint", 0.4}}).translation().z(), 0.752 + 0.2, 1e-9);
  EXPECT_NEAR(pose_of("torso_lift_link", {{"torso_lift_joint", 0.3}}).translation().z(), 0.752, 1e-9);
}

/// How far a shape reaches from the vertical axis of the base, by its corners.
double reach_of(const LinkShape& shape, const Eigen::Isometry3d& T_base_link) {
  Eigen::Vector3d half = shape.dimensions / 2.0;
  if (shape.kind == LinkShape::Kind::kSphere) half.setConstant(shape.dimensions.x() / std::sqrt(2.0));
  if (shape.kind == LinkShape::Kind::kCylinder) return 0.0;  // corners would overstate it; measured below by its ends
  double reach = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    reach = std::max(reach, (T_base_link * shape.T_link_shape * half.cwiseProduct(sign).eval()).head<2>().norm());
  }
  return reach;
}

TEST(HsrModelTest, FoldedArmStaysWithinTheBase) {
  const std::vector<Eigen::Isometry3d> poses = ours().link_poses({});
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (const LinkShape& shape : ours().links[i].collisions) {
      EXPECT_LE(reach_of(shape, poses[i]), ours().body_radius_m + 0.005) << ours().links[i].name;
      if (shape.kind != LinkShape::Kind::kCylinder) continue;
      const Eigen::Vector3d axis = (poses[i] * shape.T_link_shape).linear().col(2) * shape.dimensions.y() / 2.0;
      const Eigen::Vector3d middle = (poses[i] * shape.T_link_shape).translation();
      EXPECT_LE((middle + axis).head<2>().norm(), ours().body_radius_m) << ours().links[i].name;
      EXPECT_LE((middle - axis).head<2>().norm(), ours().body_radius_m) << ours().links[i].name;
    }
  }
}

TEST(HsrModelTest, NothingOfTheRobotStandsInTheDrivingView) {
  const CameraIntrinsics& k = ours().camera;
  for (const double tilt : {0.0, -0.3, -0.55, -0.8}) {
    const Eigen::Isometry3d T_camera_base = ours().T_base_camera({0.0, tilt}).T.inverse();
    const auto poses = ours().link_poses({{"head_tilt_joint", tilt}});
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (const LinkShape& shape : ours().links[i].visuals) {
        const Eigen::Vector3d p = T_camera_base * poses[i] * shape.T_link_shape.translation();
        if (p.z() <= 0.0) continue;
        const double u = k.fx * p.x() / p.z() + k.cx, v = k.fy * p.y() / p.z() + k.cy;
        EXPECT_FALSE(u >= 0 && v >= 0 && u < k.width && v < k.height) << ours().links[i].name << " at tilt " << tilt;
      }
    }
  }
}

RC_GTEST_PROP(HsrModelProperty, PosesAreRigidAndTheCameraKeepsItsDistance, ()) {
  const double pan = *rc::gen::inRange(-3840, 1750) / 1000.0, tilt = *rc::gen::inRange(-1570, 520) / 1000.0;
  for (const Eigen::Isometry3d& T : ours().link_poses({{"head_pan_joint", pan}, {"head_tilt_joint", tilt}})) {
    RC_ASSERT((T.linear().transpose() * T.linear() - Eigen::Matrix3d::Identity()).norm() < 1e-9);
  }
  const Eigen::Vector3d axis =
      Eigen::AngleAxisd(pan, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0.02, 0, 0) + Eigen::Vector3d(0, 0, 0.752);
  const double distance = (ours().T_base_camera({pan, tilt}).position() - axis).norm();
  RC_ASSERT(std::abs(distance - std::sqrt(0.079796 * 0.079796 + 0.022 * 0.022 + 0.215172 * 0.215172)) < 1e-9);
}

}  // namespace
}  // namespace amiss::robot
