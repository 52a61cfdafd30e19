#include "dataset/tum_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/files.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::dataset {
namespace {

constexpr CameraIntrinsics kCamera{8, 6, 10, 10, 3.5, 2.5};

PosedFrame frame_at(int i) {
  PosedFrame posed;
  posed.frame.stamp = Stamp(std::chrono::milliseconds(100 * i));
  posed.frame.intrinsics = kCamera;
  for (int k = 0; k < 48; ++k) {
    posed.frame.colour.push_back({static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(i), 9});
    posed.frame.depth_m.push_back(k % 7 == 0 ? std::nanf("") : 0.001F * static_cast<float>(500 + k + i));
  }
  posed.T_map_camera.T.translate(Eigen::Vector3d(i, 0.5, -1));
  posed.T_map_camera.T.rotate(Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d::UnitZ()));
  return posed;
}

TEST(TumWriter, WhatIsWrittenIsRead) {
  const test::TemporaryFolder folder;
  TumWriter writer(folder.path() / "run", {kCamera, 1000.0});
  for (int i = 0; i < 3; ++i) writer.add(frame_at(i));
  writer.finish();
  const auto recording = open_recording(folder.path() / "run");
  EXPECT_EQ(recording->format(), "TUM RGB-D folder");
  ASSERT_EQ(recording->size(), 3U);
  EXPECT_EQ(recording->dropped(), 0U);
  for (int i = 0; i < 3; ++i) {
    const PosedFrame expected = frame_at(i), read = recording->load(static_cast<std::size_t>(i));
    EXPECT_EQ(read.frame.stamp, expected.frame.stamp);
    EXPECT_EQ(read.frame.intrinsics, kCamera);
    EXPECT_EQ(read.frame.colour, expected.frame.colour);
    EXPECT_TRUE(read.T_map_camera.T.isApprox(expected.T_map_camera.T, 1e-12));
    for (std::size_t k = 0; k < 48; ++k) {
      const float d = expected.frame.depth_m[k];
      EXPECT_TRUE(std::isnan(d) ? std::isnan(read.frame.depth_m[k]) : std::abs(read.frame.depth_m[k] - d) < 1e-6F) << k;
    }
  }
}

TEST(TumWriter, EstimatedPosesAreReadAndTrueOnesStandApart) {
  const test::TemporaryFolder folder;
  TumWriter writer(folder.path() / "run", {kCamera, kTumDepthScale});
  Transform<Map, Camera> T_map_camera_true;
  T_map_camera_true.T.translation() = Eigen::Vector3d(7, 8, 9);
  for (int i = 0; i < 2; ++i) writer.add(frame_at(i), T_map_camera_true);
  EXPECT_THROW(writer.add(frame_at(2)), ArgumentError) << "the true pose is missing";
  writer.finish();
  writer.save_associations();
  EXPECT_TRUE(open_recording(folder.path() / "run")->load(1).T_map_camera.T.isApprox(frame_at(1).T_map_camera.T, 1e-12));
  RecordingOptions true_poses;
  true_poses.poses = folder.path() / "run" / "groundtruth.txt";
  EXPECT_TRUE(open_recording(folder.path() / "run", true_poses)->load(1).T_map_camera.T.isApprox(T_map_camera_true.T));
  const auto truth = parse_tum_trajectory(load_bytes(folder.path() / "run" / "groundtruth.txt"), "groundtruth.txt");
  ASSERT_EQ(truth.size(), 2U);
  EXPECT_TRUE(truth[1].T_map_camera.T.isApprox(T_map_camera_true.T, 1e-12));
  EXPECT_EQ(load_bytes(folder.path() / "run" / "associations.txt"),
            "0.000000000 rgb/0.000000000.png 0.000000000 depth/0.000000000.png\n"
            "0.100000000 rgb/0.100000000.png 0.100000000 depth/0.100000000.png\n");
}

TEST(TumWriter, RefusesWhatDoesNotFit) {
  const test::TemporaryFolder folder;
  TumWriter writer(folder.path() / "run", {kCamera, 1000.0});
  writer.add(frame_at(1));
  EXPECT_THROW(writer.add(frame_at(1)), ArgumentError);
  PosedFrame other = frame_at(2);
  other.frame.intrinsics.fx = 11;
  EXPECT_THROW(writer.add(other), ArgumentError);
  EXPECT_THROW(TumWriter(folder.path() / "run", {kCamera, 1000.0}), ArgumentError);
  EXPECT_THROW((void)open_recording(folder.path() / "run"), InputError) << "no lists were written yet";
}

}  // namespace
}  // namespace amiss::dataset
