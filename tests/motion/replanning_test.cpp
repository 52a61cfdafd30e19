// Drive maps, planner and follower together: a flat with things in it that the reference does not know.
#include <gtest/gtest.h>

#include "motion/drive_sim.hpp"
#include "motion/path_planner.hpp"
#include "motion/test_flat.hpp"

namespace amiss::motion {
namespace {

using Pose = Pose2<Map, Base>;

struct Tour {
  bool arrived = false;
  int plans = 0;
  double least_gap_m = 10.0, time_s = 0.0;
};

/// What the laser saw stays in the map; a blocked path is planned anew.
Tour drive_with_replanning(const FloorGrid& truth, const Pose& start, const Pose& goal, double noise_m,
                           std::uint64_t seed) {
  RandomStream random(seed, "replanning");
  DriveMap map(test_flat(), {});
  FloorGrid seen(0.05, map.grid().origin_m(), map.grid().width(), map.grid().height());
  DriveSim sim;
  sim.pose = start;
  sim.noise_m = noise_m;
  sim.random = random.child("sim");
  PlannerParams params;
  params.goal_tolerance_m = 0.4;
  Tour tour;
  for (; tour.plans < 12 && !tour.arrived; ++tour.plans) {
    const Pose here = sim.estimate();
    for (const auto& hit : sim.laser_base(truth)) {
      const Cell c = seen.cell_at(here.position() + Eigen::Rotation2Dd(here.yaw_rad) * hit);
      if (seen.contains(c)) seen.set(c, Occupancy::kOccupied);
    }
    std::vector<Eigen::Vector2d> hits;
    for (std::size_t i = 0; i < seen.cells().size(); ++i) {
      const auto width = static_cast<std::size_t>(seen.width());
      const Cell c{static_cast<int>(i % width), static_cast<int>(i / width)};
      if (seen.at(c) == Occupancy::kOccupied) hits.push_back(seen.centre_of(c));
    }
    map.update({}, hits);
    const auto planned = plan_path(map, here, goal, params, random);
    if (!planned) return tour;
    Follower follower({}, {});
    follower.start(planned->path);
    const DriveLog log = drive(follower, sim, map, truth, 200.0);
    tour.least_gap_m = std::min(tour.least_gap_m, log.least_gap_m);
    tour.time_s += log.time_s;
    tour.arrived = log.status == FollowStatus::kArrived;
  }
  return tour;
}

TEST(Replanning, FindsItsWayRoundUnknownThingsWithoutTouchingThem) {
  RandomStream random(5, "things");
  int arrived = 0, tours = 0;
  for (std::uint64_t i = 0; i < 16; ++i) {
    SCOPED_TRACE(std::to_string(i));
    FloorGrid truth = test_flat();
    const Pose start{4.0, 4.2, 0.0}, goal{9.3, 5.6, 1.0};
    for (int thing = 0; thing < 6; ++thing) {
      const double x = random.uniform(0.5, 11.0), y = random.uniform(3.2, 7.0), size = random.uniform(0.05, 0.2);
      const Eigen::Vector2d p(x, y);
      if ((p - start.position()).norm() < 0.7 || (p - goal.position()).norm() < 0.7) continue;
      fill_rect(truth, x, y, x + size, y + size, Occupancy::kOccupied);
    }
    const bool possible = [&] {
      RandomStream dice(i, "possible");
      DriveParams wide;
      wide.robot_radius_m = 0.36;
      return static_cast<bool>(plan_path(DriveMap(truth, wide), start, goal, {}, dice));
    }();
    const Tour tour = drive_with_replanning(truth, start, goal, 0.01, i);
    EXPECT_GE(tour.least_gap_m, 0.232);
    EXPECT_TRUE(tour.arrived || !possible) << tour.plans << " plans";
    arrived += tour.arrived ? 1 : 0;
    tours += possible ? 1 : 0;
  }
  EXPECT_GE(tours, 6);
  EXPECT_GE(arrived, tours);
}

}  // namespace
}  // namespace amiss::motion
