// Read back by MRPT, and by its rawlog-edit where it is installed.
#include "recording/rawlog_writer.hpp"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CRawlog.h>

#include <array>
#include <cmath>
#include <limits>

#include "recording/rawlog_reader.hpp"
#include "recording/small_rawlog.hpp"

namespace amiss::recording {
namespace {

using namespace std::chrono_literals;

robot::Observation observation(int period) {
  robot::Observation o;
  o.stamp = Stamp{100ms * period};
  o.odometry = {o.stamp, {0.1 * period, 0.2, 0.3}};
  o.scan = LaserScan{o.stamp, -1.0, 0.5, 0.05, 30.0, {1.0F, std::numeric_limits<float>::quiet_NaN(), 3.0F}};
  if (period != 2) return o;
  auto& [frame, T_base_camera, T_odom_base] = o.frame.emplace();
  frame = {
      o.stamp, {8, 4, 5.0, 5.0, 3.5, 1.5}, std::vector<Rgb>(32, Rgb{200, 100, 50}), std::vector<float>(32, 1.234F)};
  frame.depth_m[3] = std::numeric_limits<float>::quiet_NaN();
  // Optical: z of the camera along x of the base.
  T_base_camera.T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  T_base_camera.T.translation() = Eigen::Vector3d(0.1, 0.0, 1.0);
  return o;
}

Transform<Base, Laser> laser() {
  Transform<Base, Laser> T_base_laser;
  T_base_laser.T.translation() = Eigen::Vector3d(0.2, 0.0, 0.18);
  return T_base_laser;
}

std::filesystem::path written(const test::TemporaryFolder& folder, int periods) {
  const auto file = folder.path() / "a.rawlog";
  RawlogWriter writer(file, laser(), true);
  for (int period = 1; period <= periods; ++period) writer.record(observation(period));
  writer.close();
  return file;
}

TEST(RawlogWriter, MrptReadsWhatTheRobotSaid) {
  const test::TemporaryFolder folder;
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(written(folder, 3).string()));
  ASSERT_EQ(log.size(), 7U);
  const auto odometry = std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(log.getAsObservation(2));
  ASSERT_TRUE(odometry);
  EXPECT_DOUBLE_EQ(odometry->odometry.x(), 0.2);
  EXPECT_NEAR(mrpt::Clock::toDouble(odometry->timestamp), 0.2, 1e-6);
  const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(log.getAsObservation(3));
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->getScanSize(), 3U);
  EXPECT_EQ(scan->getScanRange(2), 3.0F);
  EXPECT_FALSE(scan->getScanRangeValidity(1));
  EXPECT_NEAR(scan->aperture, 1.0, 1e-6);
  EXPECT_NEAR(scan->sensorPose.x(), 0.2, 1e-9);
  EXPECT_NEAR(scan->sensorPose.yaw(), -0.5, 1e-6) << "the middle of -1 .. 0";
}

TEST(RawlogWriter, FramesKeepDepthToAMillimetreAndColours) {
  const test::TemporaryFolder folder;
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(written(folder, 2).string()));
  const auto frame = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(log.getAsObservation(4));
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->rangeImage(1, 1), 1234);
  EXPECT_EQ(frame->rangeImage(0, 3), 0);
  EXPECT_NEAR(frame->sensorPose.x(), 0.1, 1e-9);
  EXPECT_NEAR(frame->sensorPose.yaw(), 0.0, 1e-9) << "looks ahead, as MRPT's cameras do";
  EXPECT_NEAR(frame->sensorPose.roll(), 0.0, 1e-9);
  EXPECT_NEAR(frame->cameraParams.fx(), 5.0, 1e-9);
  const auto* bgr = frame->intensityImage.ptr<std::uint8_t>(2, 2);
  EXPECT_NEAR(bgr[0], 50, 8);
  EXPECT_NEAR(bgr[2], 200, 8);
}

TEST(RawlogWriter, MrptReadsWhatAReplayNeeds) {
  const test::TemporaryFolder folder;
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(test::small_rawlog(folder, 2, true).string()));
  ASSERT_EQ(log.size(), 14U);
  const auto document = std::dynamic_pointer_cast<mrpt::obs::CObservationRawDAQ>(log.getAsObservation(1));
  ASSERT_TRUE(document);
  EXPECT_EQ(document->sensorLabel, "/amiss/documents/params.yaml");
  EXPECT_EQ(std::string(document->AIN_8bits.begin(), document->AIN_8bits.end()), "a: 1\n");
}

TEST(RawlogWriter, RawlogEditReadsIt) {
  if (std::system("command -v rawlog-edit >/dev/null") != 0) GTEST_SKIP() << "rawlog-edit is not installed";
  const test::TemporaryFolder folder;
  FILE* pipe = ::popen(("rawlog-edit -i '" + written(folder, 3).string() + "' --info 2>&1").c_str(), "r");
  std::string said;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) said += buffer.data();
  EXPECT_EQ(::pclose(pipe), 0) << said;
  for (const char* words : {"LASER, ODOMETRY", "CAMERA /", "objects         : 7"}) {
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
}

TEST(RawlogWriter, AFolderThatIsNotThereIsRefused) {
  EXPECT_THROW(RawlogWriter("/nonexistent/a.rawlog", Transform<Base, Laser>{}, false), std::runtime_error);
}

TEST(RawlogWriter, BatchesFollowOneAnotherAndThreadsChangeNothing) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = written(folder, 25);  // 2.5 s
  const std::string bytes = folder.read("a.rawlog");
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(file.string()));
  EXPECT_EQ(log.size(), 51U);
  RawlogWriter alone(file, laser(), false);
  for (int period = 1; period <= 25; ++period) alone.record(observation(period));
  ASSERT_TRUE(log.loadFromRawLogFile(file.string())) << "what was handed over is there already";
  EXPECT_EQ(log.size(), 49U);  // all but the 25th period, at 2.5 s, which begins a batch
  RawlogReader reader(file);
  while (reader.next()) {
  }
  EXPECT_FALSE(reader.complete());
  alone.close();
  EXPECT_TRUE(folder.read("a.rawlog") == bytes);
}

TEST(RawlogWriter, AFullDiskIsToldInOneSentence) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.rawlog";
  std::filesystem::create_symlink("/dev/full", file);
  RawlogWriter writer(file, laser(), true);
  for (int period = 1; period <= 3; ++period) writer.record(observation(period));
  EXPECT_EQ(test::sentence_of<std::runtime_error>([&] { writer.close(); }), file.string() + ": cannot be written");
}

}  // namespace
}  // namespace amiss::recording
