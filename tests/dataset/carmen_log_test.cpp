#include "dataset/carmen_log.hpp"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/carmen_log_tools.h>

#include <limits>
#include <sstream>

namespace amiss::dataset {
namespace {

/// MRPT's own reader of such logs says what another program would see.
TEST(CarmenLog, AnotherReaderSeesWhatWasWritten) {
  Odometry odometry{Stamp(std::chrono::milliseconds(1500)), {1.0, -2.0, 0.5}};
  LaserScan scan;
  scan.stamp = odometry.stamp;
  scan.angle_min_rad = -0.2;
  scan.angle_step_rad = 0.1;
  scan.max_range_m = 20.0;
  scan.ranges_m = {1.25F, std::numeric_limits<float>::quiet_NaN(), 3.0F, 0.5F, 2.0F};
  Transform<Base, Laser> mount;
  mount.T.translation() = Eigen::Vector3d(0.17, 0.0, 0.18);
  CarmenLog log;
  log.add(odometry);
  log.add(scan, odometry, mount);

  std::istringstream lines(log.bytes());
  std::vector<mrpt::obs::CObservation::Ptr> seen;
  mrpt::system::TTimeStamp begin = mrpt::Clock::fromDouble(0.0);
  while (mrpt::obs::carmen_log_parse_line(lines, seen, begin)) {
    for (const auto& one : seen) {
      if (const auto laser = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(one)) {
        ASSERT_EQ(laser->getScanSize(), 5U);
        EXPECT_NEAR(laser->getScanRange(0), 1.25, 1e-6);
        EXPECT_NEAR(laser->getScanRange(3), 0.5, 1e-6);
        EXPECT_NEAR(laser->aperture, 0.4, 1e-4);
        EXPECT_NEAR(laser->sensorPose.x(), 0.17, 1e-4);
        return;
      }
    }
  }
  FAIL() << log.bytes();
}

TEST(CarmenLog, OdometryIsOneLine) {
  CarmenLog log;
  log.add(Odometry{Stamp(std::chrono::milliseconds(20)), {1.0, -2.0, 0.5}});
  EXPECT_NE(log.bytes().find("\nODOM 1.000000 -2.000000 0.500000 0 0 0 0.020000000 amiss 0.020000000\n"),
            std::string::npos);
}

}  // namespace
}  // namespace amiss::dataset
