#include "dataset/trajectory_files.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"

namespace amiss::dataset {
namespace {

TEST(TrajectoryFiles, TumRoundTripIsExactInTimeAndPlace) {
  std::vector<StampedPose> poses(2);
  poses[0].stamp = Stamp(Duration(1305031102175304001));
  poses[0].T_map_camera.T.translate(Eigen::Vector3d(1.5, -2.25, 1e-9));
  poses[1].stamp = Stamp(Duration(1305031102175304002));
  poses[1].T_map_camera.T.rotate(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()));
  const auto again = parse_tum_trajectory(tum_trajectory_bytes(poses), "poses");
  ASSERT_EQ(again.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again[i].stamp, poses[i].stamp);
    EXPECT_EQ(again[i].T_map_camera.position(), poses[i].T_map_camera.position());
    EXPECT_TRUE(again[i].T_map_camera.T.isApprox(poses[i].T_map_camera.T, 1e-12));
  }
}

TEST(TrajectoryFiles, MatricesMustBeRigidMotions) {
  const std::string pose = "0 -1 0 1\n1 0 0 2\n\n0 0 1 3\n0 0 0 1\n";
  EXPECT_EQ(parse_pose_matrix(pose, "pose").position(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(parse_open3d_log("0 0 1\n" + pose + "1 1 2\n" + pose, "log").size(), 2U);
  EXPECT_THROW((void)parse_pose_matrix("2 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", "scaled"), InputError);
  EXPECT_THROW((void)parse_pose_matrix("-1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", "mirrored"), InputError);
  EXPECT_THROW((void)parse_pose_matrix("1 0 0 0\n0 1 0 0\n0 0 1 0\n", "short"), InputError);
  EXPECT_THROW((void)parse_open3d_log("0 0\n" + pose, "log"), InputError);
}

TEST(TrajectoryFiles, SaysFileAndLine) {
  const auto why = [](const std::string& text) {
    try {
      (void)parse_tum_trajectory(text, "poses.txt");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(why("# none\n1 0 0 0 0 0 0\n"), "poses.txt:2: a pose is 't x y z qx qy qz qw', eight numbers");
  EXPECT_EQ(why("1 0 0 nan 0 0 0 1\n"), "poses.txt:1: 'nan' is no finite number");
  EXPECT_EQ(why("1 0 0 0 0 0 0 0\n"), "poses.txt:1: the quaternion's length must be 1");
  EXPECT_EQ(why("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"), "poses.txt:2: times must grow");
  EXPECT_EQ(why("yesterday 0 0 0 0 0 0 1\n"), "poses.txt:1: 'yesterday' is no time in seconds");
}

}  // namespace
}  // namespace amiss::dataset
