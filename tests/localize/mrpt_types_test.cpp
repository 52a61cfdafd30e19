#include "localize/internal/mrpt_types.hpp"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <rapidcheck/gtest.h>

#include "localize/internal/distance_field.hpp"

namespace amiss::localize::internal {
namespace {

RC_GTEST_PROP(Scan, HasTheSamePointsAsMrpts, ()) {
  LaserScan scan;
  scan.angle_min_rad = *rc::gen::inRange(-31, 0) / 10.0;
  scan.angle_step_rad = *rc::gen::inRange(5, 30) / 1000.0;
  scan.min_range_m = 0.05;
  scan.max_range_m = 20.0;
  const int beams = *rc::gen::inRange(10, 100);
  for (int i = 0; i < beams; ++i) {
    scan.ranges_m.push_back(i % 7 == 3 ? std::nanf("") : 1.0F + 0.1F * static_cast<float>(i % 5));
  }
  Transform<Base, Laser> T_base_laser;
  T_base_laser.T.translate(Eigen::Vector3d(0.2, -0.1, 0.3)).rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  const auto ours = points_of(scan, T_base_laser, beams);
  mrpt::maps::CSimplePointsMap theirs;
  theirs.insertionOptions.minDistBetweenLaserPoints = 0.0F;
  theirs.insertObservation(*to_mrpt(scan, T_base_laser, beams));
  RC_ASSERT(ours.size() == theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    float x = 0.0F, y = 0.0F;
    theirs.getPoint(i, x, y);
    RC_ASSERT((ours[i] - Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y))).norm() < 1e-4);
  }
}

RC_GTEST_PROP(Grid, HasTheSameCellsAtAnyOrigin, ()) {
  FloorGrid grid(0.05, {*rc::gen::inRange(-300, 300) / 100.0 + 0.013, 1.027}, 37, 23);
  for (int i = 0; i < 60; ++i) {
    grid.set({*rc::gen::inRange(0, 37), *rc::gen::inRange(0, 23)},
             i % 2 == 0 ? Occupancy::kFree : Occupancy::kOccupied);
  }
  const auto theirs = to_mrpt(grid);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Eigen::Vector2d p = grid.centre_of({x, y}) - grid.origin_m();
      const float free = theirs->getPos(static_cast<float>(p.x()), static_cast<float>(p.y()));
      const Occupancy cell = grid.at(Cell{x, y});
      RC_ASSERT((free > 0.9F) == (cell == Occupancy::kFree));
      RC_ASSERT((free < 0.1F) == (cell == Occupancy::kOccupied));
    }
  }
}

}  // namespace
}  // namespace amiss::localize::internal
