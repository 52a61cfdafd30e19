// A rawlog as MRPT writes it, read as a recording of a depth camera; and one that MRPT's makers recorded.
#include "recording/rawlog_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/result.hpp"
#include "mapping/test_data.hpp"
#include "recording/small_rawlog.hpp"

namespace amiss::recording {
namespace {

std::string why(const std::filesystem::path& file, const dataset::RecordingOptions& options = {}) {
  return test::sentence_of<InputError>([&] { static_cast<void>(open_rawlog(file, options)); });
}

TEST(RawlogFrames, OdometrySaysWhereTheCameraWas) {
  const test::TemporaryFolder folder;
  const auto file = test::small_rawlog(folder, 5, false);
  EXPECT_TRUE(is_rawlog(file));
  const auto recording = open_rawlog(file);
  EXPECT_EQ(recording->format(), "MRPT rawlog");
  ASSERT_EQ(recording->size(), 2U);  // of the periods 2 and 4
  EXPECT_EQ(recording->dropped(), 0U);
  for (const std::size_t i : {1U, 0U, 1U}) {  // in any order
    const robot::Observation said = test::rawlog_observation(2 * static_cast<int>(i) + 2);
    const dataset::PosedFrame posed = recording->load(i);
    EXPECT_EQ(posed.frame.stamp, said.stamp);
    const Eigen::Isometry3d T = said.odometry.T_odom_base.lift().T * said.frame->T_base_camera.T;
    EXPECT_TRUE(posed.T_map_camera.T.isApprox(T, 1e-9)) << posed.T_map_camera.T.matrix();
    EXPECT_EQ(posed.frame.intrinsics, said.frame->frame.intrinsics);
    ASSERT_EQ(posed.frame.depth_m.size(), 8U);
    EXPECT_NEAR(posed.frame.depth_m[0], 1.234F, 1e-6F);
    EXPECT_TRUE(std::isnan(posed.frame.depth_m[1]));
    ASSERT_EQ(posed.frame.colour.size(), 8U);
    EXPECT_NEAR(posed.frame.colour[5].r, 200, 8);  // JPEG
    EXPECT_NEAR(posed.frame.colour[5].b, 50, 8);
  }
}

TEST(RawlogFrames, ATrajectoryOfTheUserGoesBeforeOdometry) {
  const test::TemporaryFolder folder;
  dataset::RecordingOptions options;
  options.poses = folder.write("poses.txt", "0.1 1 0 0 0 0 0 1\n0.3 3 0 0 0 0 0 1\n");
  const auto recording = open_rawlog(test::small_rawlog(folder, 5, false), options);
  ASSERT_EQ(recording->size(), 1U);
  EXPECT_EQ(recording->dropped(), 1U) << "0.4 s: no pose of it";
  EXPECT_NEAR(recording->load(0).T_map_camera.position().x(), 2.0, 1e-9);
}

TEST(RawlogFrames, AFileThatBreaksOffIsReadUpToThere) {
  const test::TemporaryFolder folder;
  const std::string whole = test::unpacked(test::small_rawlog(folder, 6, false));
  const auto recording = open_rawlog(folder.write("cut.rawlog", whole.substr(0, whole.size() - 1)));
  EXPECT_EQ(recording->format(), "MRPT rawlog that breaks off");
  EXPECT_EQ(recording->size(), 2U);
}

TEST(RawlogFrames, SaysWhatIsMissing) {
  const test::TemporaryFolder folder;
  EXPECT_NE(why(test::small_rawlog(folder, 1, false)).find("a.rawlog: has no depth images"), std::string::npos);
  dataset::RecordingOptions options;
  options.poses = folder.write("poses.txt", "9 1 0 0 0 0 0 1\n");
  EXPECT_NE(
      why(test::small_rawlog(folder, 2, false), options).find("has no frame with colour, depth and a pose (1 lack"),
      std::string::npos);
  EXPECT_FALSE(is_rawlog(folder.write("text", "mrpt")));
  EXPECT_FALSE(is_rawlog(folder.write("empty", "")));
}

TEST(RawlogFrames, WhatMrptsMakersRecordedIsReadOrRefusedInASentence) {
  const auto data = mapping::test_data() / "mrpt";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << data << " is not there";
  const test::TemporaryFolder folder;  // its one frame is of May 2016, without odometry
  dataset::RecordingOptions options;
  options.poses = folder.write("poses.txt", "1462879443.5 0 0 1 0 0 0 1\n1462879443.7 0 0 1 0 0 0 1\n");
  const auto recording = open_rawlog(data / "tests_rgbd.rawlog", options);
  ASSERT_EQ(recording->size(), 1U);
  const RgbdFrame frame = recording->load(0).frame;
  EXPECT_EQ(frame.intrinsics.width, 640);
  EXPECT_NEAR(frame.intrinsics.fx, 572.88, 0.01);
  const auto seen = std::count_if(frame.depth_m.begin(), frame.depth_m.end(), [](float z) { return z > 0.5F; });
  EXPECT_GT(seen, 250000);
  // A white wall above a shelf of wood, in the eye for colours once 1.5 mm and some pixels away.
  const Rgb wall = frame.colour[60 * 640 + 200], wood = frame.colour[184 * 640 + 120];
  EXPECT_GT(wall.b, 100);
  EXPECT_GT(wood.r, wood.b + 20);
  EXPECT_NE(why(data / "tests_rgbd.rawlog").find("it has no odometry, --poses FILE"), std::string::npos);
  EXPECT_NE(why(data / "test-3d-obs-ground.rawlog").find("a CSensoryFrame of version 2 is not read"),
            std::string::npos);
}

}  // namespace
}  // namespace amiss::recording
