#include "sim/scripted_robot.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "sim/rooms.hpp"

namespace amiss::sim {
namespace {

using world::Moment;

Moment time(double at_s) { return {Moment::Kind::kTime, at_s, {}, 0.0, ""}; }

struct Scripted : testing::Test {
  Worker worker{false};
  std::map<std::string, world::Body> bodies{
      {"brick", test::block("brick", {0.1, 0.1, 0.1}, {0, 0, 0}, false)},
      {"person", test::block("person", {0.3, 0.3, 1.7}, {0, 0, 0.85})},
  };

  /// The simulator of a room of 5 m x 4 m with a cupboard, and what the script changes in it.
  std::unique_ptr<Simulator> simulator_for(const world::Script& script) {
    world::World world = test::room(5, 4);
    world.bodies.push_back(test::block("cupboard", {0.5, 1.0, 1.2}, {4.7, 3, 0.6}));
    const std::vector<world::Body> movable = unfix(world, script);
    SimulatorParams params;
    params.camera_period_s = 60.0;
    auto simulator =
        std::make_unique<Simulator>(world, test::small_robot(), params, 1, Pose2<amiss::World, Base>{1, 2, 0}, worker);
    for (const world::Body& body : movable) simulator->add_object(body, body.pose, body.name);
    return simulator;
  }
  static std::optional<Eigen::Vector3d> place_of(const Simulator& simulator, const std::string& name) {
    for (const world::ObjectTruth& o : simulator.truth().objects) {
      if (o.name == name) return o.pose.position();
    }
    return std::nullopt;
  }
  static void pass(ScriptedRobot& robot, double time_s) {
    for (int i = 0; i < std::lround(time_s / 0.02); ++i) (void)robot.observe();
  }
};

TEST_F(Scripted, AddsDropsMovesAndRemoves) {
  const world::Script script{{{time(0), world::AddBody{"brick", "one", {2, 1, {}, 0}}},
                              {time(0.1), world::AddBody{"brick", "two", {2, 3, 0.5, 0}}},
                              {time(1.5), world::MoveBody{"one", {3, 1, {}, 0}}},
                              {time(1.5), world::MoveBody{"cupboard", {4.0, 3, {}, 0}}},
                              {time(2.0), world::RemoveBody{"two"}}}};
  const auto simulator = simulator_for(script);
  ScriptedRobot robot(*simulator, script, bodies, 1);
  EXPECT_NEAR(place_of(*simulator, "one")->z(), 0.05, 1e-9) << "it stands on the floor before the first observation";
  EXPECT_FALSE(place_of(*simulator, "two"));
  pass(robot, 1.2);
  EXPECT_NEAR(place_of(*simulator, "two")->z(), 0.05, 0.01) << "it fell";
  EXPECT_EQ(robot.not_happened().size(), 3U);
  pass(robot, 1.0);
  EXPECT_NEAR(place_of(*simulator, "one")->x(), 3.0, 1e-6);
  EXPECT_NEAR(place_of(*simulator, "cupboard")->x(), 4.0, 1e-9);
  EXPECT_FALSE(place_of(*simulator, "two"));
  EXPECT_TRUE(robot.not_happened().empty());
  ASSERT_EQ(robot.happened().size(), 5U);
  EXPECT_EQ(robot.happened()[4].what, "two is taken away");
}

TEST_F(Scripted, LaserSeesFurnitureWhereItIsNow) {
  const world::Script script{{{time(0.5), world::MoveBody{"cupboard", {2.5, 2, {}, 0}}}}};
  const auto simulator = simulator_for(script);
  ScriptedRobot robot(*simulator, script, bodies, 1);
  const auto ahead = [&] {
    std::optional<LaserScan> scan;
    while (!scan) scan = robot.observe().scan;
    return scan->ranges_m[scan->ranges_m.size() / 2];
  };
  EXPECT_NEAR(ahead(), 5.0 - 1.1675, 0.06);
  pass(robot, 0.6);
  EXPECT_NEAR(ahead(), 2.25 - 1.1675, 0.06);
}

TEST_F(Scripted, WaitsForTheRobotAndForWhatItIsTold) {
  const world::Script script{
      {{{Moment::Kind::kRobotNear, 0.5, {2, 2}, 0.5, ""}, world::AddBody{"brick", "near", {4, 1, {}, 0}}},
       {{Moment::Kind::kDetected, 0.0, {}, 0.0, "near"}, world::RemoveBody{"near"}},
       {{Moment::Kind::kExamined, 0.0, {}, 0.0, "near"}, world::AddBody{"brick", "far", {4, 1, {}, 0}}}}};
  const auto simulator = simulator_for(script);
  ScriptedRobot robot(*simulator, script, bodies, 1);
  pass(robot, 1.0);
  EXPECT_TRUE(robot.happened().empty());
  robot::Command forward;
  forward.velocity_base_m_s = {0.3, 0.0};
  robot.command(forward);
  pass(robot, 2.5);
  EXPECT_TRUE(robot.happened().empty()) << "half a second later";
  pass(robot, 1.0);
  EXPECT_TRUE(place_of(*simulator, "near"));
  robot.detected("something else");
  pass(robot, 0.1);
  EXPECT_TRUE(place_of(*simulator, "near"));
  robot.detected("near");
  robot.examined("near");
  pass(robot, 0.1);
  EXPECT_FALSE(place_of(*simulator, "near"));
  EXPECT_TRUE(place_of(*simulator, "far"));
}

TEST_F(Scripted, SomebodyWalksThroughAndWaitsForTheRobot) {
  const world::Script script{{{time(0), world::Walk{"anna", {{4, 2}, {0.3, 2}, {0.3, 3.5}}, 1.0}}}};
  const auto simulator = simulator_for(script);
  ScriptedRobot robot(*simulator, script, bodies, 1);
  pass(robot, 8.0);
  ASSERT_TRUE(place_of(*simulator, "anna"));
  EXPECT_NEAR(place_of(*simulator, "anna")->x(), 1.75, 0.05) << "the robot stands in the way at x = 1";
  simulator->carry_robot({3, 1, 0});
  pass(robot, 4.0);
  EXPECT_FALSE(place_of(*simulator, "anna")) << "she went on and is gone";
  EXPECT_TRUE(simulator->collisions().empty());
}

TEST_F(Scripted, KidnappingIsNotFelt) {
  const world::Script script{{{time(0.5), world::Kidnap{{3, 1, 1.0}}}}};
  const auto simulator = simulator_for(script);
  ScriptedRobot robot(*simulator, script, bodies, 1);
  pass(robot, 1.0);
  EXPECT_NEAR(simulator->truth().T_world_base.x_m, 3.0, 1e-9);
  EXPECT_NEAR(robot.observe().odometry.T_odom_base.x_m, 0.0, 1e-9);
}

TEST_F(Scripted, DoorsAreClosedInTheirFrames) {
  world::Script script{{{time(0), world::CloseDoor{"leaf", "frame"}}}};
  world::World world = test::room(5, 4);
  world.bodies.push_back(test::block("leaf", {0.04, 0.9, 2.0}, {2.5, 3, 1.0}));
  world.bodies.push_back(test::block("frame", {0.1, 1.0, 0.05}, {3, 2, 2.05}));
  const auto movable = unfix(world, script);
  ASSERT_EQ(movable.size(), 1U);
  EXPECT_EQ(movable[0].name, "leaf");
}

TEST_F(Scripted, WhatCannotBeIsSaid) {
  world::World world = test::room(5, 4);
  EXPECT_THROW(unfix(world, {{{time(0), world::RemoveBody{"wall_wset"}}}}), ArgumentError);
  const world::Script unknown{{{time(0), world::AddBody{"elephant", "e", {}}}}};
  const auto simulator = simulator_for({});
  EXPECT_THROW(ScriptedRobot(*simulator, unknown, bodies, 1), ArgumentError);
  const world::Script into_the_wall{{{time(0), world::Kidnap{{0.0, 2.0, 0.0}}}}};
  EXPECT_THROW(ScriptedRobot(*simulator, into_the_wall, bodies, 1), ArgumentError);
}

}  // namespace
}  // namespace amiss::sim
