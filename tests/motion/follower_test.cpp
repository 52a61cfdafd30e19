#include "motion/follower.hpp"

#include <gtest/gtest.h>

#include "motion/drive_sim.hpp"
#include "motion/path_planner.hpp"
#include "motion/test_flat.hpp"

namespace amiss::motion {
namespace {

using Pose = Pose2<Map, Base>;

Pose random_pose(const DriveMap& map, RandomStream& random) {
  while (true) {
    const double x = random.uniform(0, 12);
    const Eigen::Vector2d p(x, random.uniform(0, 7.5));
    if (map.passable(map.grid().cell_at(p))) return {p.x(), p.y(), random.uniform(-3.1, 3.1)};
  }
}

struct Trip {
  DriveLog log;
  double length_m = 0.0, position_error_m = 0.0, yaw_error_rad = 0.0;
};

Trip trip(const DriveMap& map, const Pose& start, const Pose& goal, double noise_m, std::uint64_t seed) {
  RandomStream random(seed, "trip");
  const auto planned = plan_path(map, start, goal, {}, random);
  EXPECT_TRUE(planned);
  Follower follower({}, {});
  follower.start(planned->path);
  DriveSim sim;
  sim.pose = start;
  sim.noise_m = noise_m;
  sim.random = random.child("sim");
  Trip done;
  done.length_m = planned->path.length_m();
  done.log = drive(follower, sim, map, map.grid(), 200.0);
  done.position_error_m = (sim.pose.position() - goal.position()).norm();
  done.yaw_error_rad = std::abs(wrap_angle(sim.pose.yaw_rad - goal.yaw_rad));
  return done;
}

void expect_good(const Trip& done, double noise_m) {
  EXPECT_EQ(to_string(done.log.status), "arrived");
  EXPECT_GE(done.log.least_gap_m, 0.235);  // the body has 0.23 m
  EXPECT_LE(done.log.most_speed_m_s, 0.3 + 1e-9);
  EXPECT_LE(done.position_error_m, 0.045 + 2.0 * noise_m);
  EXPECT_LE(done.yaw_error_rad, radians(3.0));
  EXPECT_LE(done.log.time_s, done.length_m / 0.3 * 1.35 + 7.0);
}

TEST(Follower, DrivesThroughTheFlatToWhereItShould) {
  const DriveMap map(test_flat(), {});
  RandomStream random(3, "trips");
  double length_m = 0.0, time_s = 0.0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Pose start = random_pose(map, random), goal = random_pose(map, random);
    SCOPED_TRACE(std::to_string(i));
    const Trip done = trip(map, start, goal, 0.0, i);
    expect_good(done, 0.0);
    EXPECT_LE(done.log.most_change_m_s2, 0.3 * 1.001);
    length_m += done.length_m;
    time_s += done.log.time_s;
  }
  RecordProperty("mean_speed_m_s", std::to_string(length_m / time_s));
  EXPECT_GT(length_m / time_s, 0.20);
}

TEST(Follower, ToleratesAPoseThatIsOffByCentimetres) {
  const DriveMap map(test_flat(), {});
  RandomStream random(4, "noisy trips");
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Pose start = random_pose(map, random), goal = random_pose(map, random);
    SCOPED_TRACE(std::to_string(i));
    expect_good(trip(map, start, goal, 0.02, i), 0.02);
  }
}

TEST(Follower, StopsBeforeWhatOnlyTheLaserSees) {
  const FloorGrid known = empty_room(6.0, 3.0);
  const DriveMap map(known, {});
  for (const double y : {1.5, 1.35, 1.3}) {
    FloorGrid truth = known;
    fill_rect(truth, 3.0, y, 3.1, y + 0.1, Occupancy::kOccupied);
    Follower follower({}, {});
    follower.start({{{1.0, 1.5}, {5.0, 1.5}}, 0.0});
    DriveSim sim;
    sim.pose = {1.0, 1.5, 0.0};
    const DriveLog log = drive(follower, sim, map, truth, 60.0);
    EXPECT_EQ(log.status, FollowStatus::kBlocked);
    EXPECT_GE(true_gap_m(truth, sim.pose.position()), 0.235);
    EXPECT_GE(sim.pose.x_m, 2.5);  // it came near before it gave up
    EXPECT_NEAR(sim.velocity_map.norm(), 0.0, 1e-6);
  }
}

TEST(Follower, StopsBeforeWhatOnlyTheMapKnows) {
  DriveMap map(empty_room(6.0, 3.0), {});
  map.update({}, std::vector<Eigen::Vector2d>{{3.0, 1.5}});
  Follower follower({}, {});
  follower.start({{{1.0, 1.5}, {5.0, 1.5}}, 0.0});
  DriveSim sim;
  sim.pose = {1.0, 1.5, 0.0};
  const DriveLog log = drive(follower, sim, map, empty_room(6.0, 3.0), 60.0);
  EXPECT_EQ(log.status, FollowStatus::kBlocked);
  EXPECT_GE(true_gap_m(map.grid(), sim.pose.position()), 0.235);
}

TEST(Follower, LeavesAPlaceThatIsTooNarrow) {
  const DriveMap map(empty_room(4.0, 4.0), {});
  Follower follower({}, {});
  follower.start({{{0.25, 2.0}, {2.0, 2.0}}, 0.0});
  DriveSim sim;
  sim.pose = {0.25, 2.0, std::numbers::pi / 2};
  const DriveLog log = drive(follower, sim, map, map.grid(), 60.0);
  EXPECT_EQ(log.status, FollowStatus::kArrived);
  EXPECT_GE(log.least_gap_m, 0.245);
}

TEST(Follower, TurnsFirstAndFacesWhereItDrives) {
  const DriveMap map(empty_room(6.0, 3.0), {});
  Follower follower({}, {});
  follower.start({{{1.0, 1.5}, {5.0, 1.5}}, 1.0});
  DriveSim sim;
  sim.pose = {1.0, 1.5, 2.5};
  for (int tick = 0; tick < 600; ++tick) {
    const FollowStep step = follower.step(sim.pose, map, {}, duration_of(DriveSim::kPeriod_s));
    if (step.status != FollowStatus::kDriving) break;
    if (step.remaining_m > 0.5 && sim.velocity_map.norm() > 0.1) {
      EXPECT_LT(std::abs(sim.pose.yaw_rad), radians(62));
    }
    sim.move(step, {});
  }
  EXPECT_GT(sim.pose.x_m, 3.0);
}

TEST(Follower, SaysWhenItIsPushedOffThePath) {
  const DriveMap map(empty_room(6.0, 3.0), {});
  Follower follower({}, {});
  follower.start({{{1.0, 1.0}, {5.0, 1.0}}, 0.0});
  const Duration period = duration_of(0.02);
  EXPECT_EQ(follower.step({1.5, 1.1, 0.0}, map, {}, period).status, FollowStatus::kDriving);
  EXPECT_EQ(follower.step({1.5, 1.6, 0.0}, map, {}, period).status, FollowStatus::kOffPath);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(follower.step({nan, 1.1, 0.0}, map, {}, period).status, FollowStatus::kOffPath);
  EXPECT_EQ(follower.step({1.5, 1.1, nan}, map, {}, period).status, FollowStatus::kOffPath);
}

TEST(Follower, OnlyTurnsWhenTheGoalIsHere) {
  const DriveMap map(empty_room(4.0, 4.0), {});
  Follower follower({}, {});
  follower.start({{{2.0, 2.0}}, 2.0});
  DriveSim sim;
  sim.pose = {2.0, 2.0, -1.0};
  const DriveLog log = drive(follower, sim, map, map.grid(), 20.0);
  EXPECT_EQ(log.status, FollowStatus::kArrived);
  EXPECT_LT(log.time_s, 5.0);
  EXPECT_NEAR(sim.pose.yaw_rad, 2.0, radians(2.5));
  EXPECT_LT((sim.pose.position() - Eigen::Vector2d(2.0, 2.0)).norm(), 0.03);
}

}  // namespace
}  // namespace amiss::motion
