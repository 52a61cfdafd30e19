// Localization on a recording of a real robot that others made; skipped where it is not there.
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cstdlib>
#include <filesystem>

#include "localize/localizer.hpp"

namespace amiss::localize {
namespace {

std::filesystem::path data_folder() {
  const char* named = std::getenv("AMISS_TEST_DATA");
  const std::filesystem::path root =
      named != nullptr ? std::filesystem::path(named) : std::filesystem::path(AMISS_SOURCE_DIR) / "../shared/data";
  return root / "mrpt";
}

struct Step {
  Odometry odometry;
  LaserScan scan;
  Transform<Base, Laser> T_base_laser;
};

LaserScan scan_of(const mrpt::obs::CObservation2DRangeScan& from, Stamp stamp) {
  LaserScan scan;
  const auto beams = from.getScanSize();
  scan.stamp = stamp;
  scan.angle_step_rad = static_cast<double>(from.aperture) / static_cast<double>(beams - 1);
  scan.angle_min_rad = -static_cast<double>(from.aperture) / 2.0;
  scan.max_range_m = static_cast<double>(from.maxRange);
  for (std::size_t i = 0; i < beams; ++i) {
    scan.ranges_m.push_back(from.getScanRangeValidity(i) ? from.getScanRange(i) : std::nanf(""));
  }
  return scan;
}

std::vector<Step> steps_of(const std::filesystem::path& file) {
  mrpt::obs::CRawlog log;
  log.loadFromRawLogFile(file.string());
  std::vector<Step> steps;
  Pose2<Odom, Base> odom;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto entry = log.getAsGeneric(i);
    if (const auto action = std::dynamic_pointer_cast<mrpt::obs::CActionCollection>(entry)) {
      const auto moved = action->getBestMovementEstimation()->rawOdometryIncrementReading;
      odom = odom * Pose2<Base, Base>{moved.x(), moved.y(), moved.phi()};
    }
    const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry);
    if (!frame) continue;
    const auto observed = frame->getObservationByClass<mrpt::obs::CObservation2DRangeScan>();
    if (!observed) continue;
    const Stamp stamp(std::chrono::seconds(steps.size()));
    Step step{{stamp, odom}, scan_of(*observed, stamp), {}};
    step.T_base_laser.T.translation() =
        Eigen::Vector3d(observed->sensorPose.x(), observed->sensorPose.y(), observed->sensorPose.z());
    steps.push_back(std::move(step));
  }
  return steps;
}

FloorGrid grid_of(const std::filesystem::path& file) {
  mrpt::maps::CSimpleMap views;
  views.loadFromFile(file.string());
  mrpt::maps::COccupancyGridMap2D drawn(-1.0F, 1.0F, -1.0F, 1.0F, 0.1F);
  drawn.loadFromSimpleMap(views);
  FloorGrid grid(0.1, {static_cast<double>(drawn.getXMin()), static_cast<double>(drawn.getYMin())},
                 static_cast<int>(drawn.getSizeX()), static_cast<int>(drawn.getSizeY()));
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const float free = drawn.getCell(x, y);
      if (free > 0.55F) grid.set({x, y}, Occupancy::kFree);
      if (free < 0.45F) grid.set({x, y}, Occupancy::kOccupied);
    }
  }
  return grid;
}

constexpr Pose2<Map, Base> kFinal{15.904, -10.010, radians(4.93)};

TEST(RecordedRobot, EndsWhereItIsKnownToEnd) {
  const auto log = data_folder() / "localization_demo.rawlog", map = data_folder() / "localization_demo.simplemap.gz";
  if (!std::filesystem::exists(log) || !std::filesystem::exists(map)) GTEST_SKIP() << data_folder() << " is not there";
  const std::vector<Step> steps = steps_of(log);
  ASSERT_GT(steps.size(), 30U);
  // Odometry alone is metres off at the start that it leads back to; the particles must find the way.
  const Pose2<Map, Base> start = kFinal * steps.back().odometry.T_odom_base.inverse() * Pose2<Odom, Base>{};
  LocalizerParams params;
  params.particles = 2000;
  params.beams = 361;  // few scans, far apart
  const FloorGrid grid = grid_of(map);
  Localizer localizer(grid, start, {1.0, radians(15.0)}, params, RandomStream(1, "localizer"));
  (void)localizer.update({Stamp{}, {}}, nullptr, {});
  PoseEstimate estimate;
  for (const Step& step : steps) estimate = localizer.update(step.odometry, &step.scan, step.T_base_laser);
  EXPECT_LT((estimate.T_map_base.position() - kFinal.position()).norm(), 0.10);
  EXPECT_LT(std::abs(wrap_angle(estimate.T_map_base.yaw_rad - kFinal.yaw_rad)), radians(1.0));
  EXPECT_TRUE(estimate.converged);
}

}  // namespace
}  // namespace amiss::localize
