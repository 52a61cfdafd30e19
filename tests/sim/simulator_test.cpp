#include "sim/simulator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/files.hpp"
#include "core/result.hpp"
#include "sim/rooms.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;

world::World playroom() {
  world::World world = test::room(5, 4);
  world.bodies.push_back(test::block("cupboard", {0.5, 1.0, 1.2}, {4.7, 3, 0.6}));
  world.bodies.push_back(test::block("brick", {0.1, 0.1, 0.1}, {3.0, 2.1, 0.3}, false));
  world.bodies.push_back(test::body("ball", world::Sphere{0.06}, {2.5, 1.2, 0.4}, false));
  return world;
}

SimulatorParams small_camera_params() { return {}; }

robot::Model small_camera_robot() {
  robot::Model model = test::small_robot();
  model.camera_link = 2;
  model.T_link_camera.translation() = Eigen::Vector3d(0.12, 0, 0.1);
  model.T_link_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // optical: x right, y down, z forward
  model.camera = CameraIntrinsics{160, 120, 134, 134, 79.5, 59.5};
  return model;
}

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

void append(std::string& bytes, const robot::Observation& seen) {
  append(bytes, seen.odometry.T_odom_base);
  append(bytes, seen.head);
  if (seen.scan)
    bytes.append(reinterpret_cast<const char*>(seen.scan->ranges_m.data()), seen.scan->ranges_m.size() * 4);
  if (!seen.frame) return;
  const RgbdFrame& frame = seen.frame->frame;
  append(bytes, frame.stamp);
  append(bytes, seen.frame->T_odom_base);
  bytes.append(reinterpret_cast<const char*>(frame.depth_m.data()), frame.depth_m.size() * sizeof(float));
  bytes.append(reinterpret_cast<const char*>(frame.colour.data()), frame.colour.size() * sizeof(Rgb));
}

/// 20 s of driving about, with things added, moved and taken away while frames are on their way.
std::string digest_of_a_drive(bool threaded) {
  Worker worker(threaded);
  Simulator simulator(playroom(), small_camera_robot(), small_camera_params(), 5, {1, 2, 0}, worker);
  std::string bytes;
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.02 * i;
    simulator.command({{0.3 * std::cos(0.3 * t), 0.1}, 0.4 * std::sin(0.5 * t), std::sin(t), -0.5});
    if (i == 211)
      simulator.add_object(test::block("book", {0.2, 0.15, 0.03}, {0, 0, 0}, false), test::at(2, 3, 0.2), "book");
    if (i == 411) simulator.move_object("book", test::at(3, 1, 0.3));
    if (i == 611) simulator.remove_object("book");
    append(bytes, simulator.observe());
  }
  for (const world::ObjectTruth& object : simulator.truth().objects) append(bytes, object.pose.T.matrix());
  return sha256(bytes);
}

TEST(Simulator, OneThreadAndTwoGiveTheSameBytes) {
  const std::string one = digest_of_a_drive(false);
  EXPECT_EQ(one, digest_of_a_drive(true));
  EXPECT_EQ(one, digest_of_a_drive(true));
}

TEST(Simulator, SensorsComeWhenTheyAreDue) {
  Worker worker(true);
  Simulator simulator(playroom(), small_camera_robot(), small_camera_params(), 1, {1, 2, 0}, worker);
  int scans = 0, frames = 0;
  for (int i = 1; i <= 250; ++i) {
    const robot::Observation seen = simulator.observe();
    EXPECT_EQ(seen.stamp, Stamp(i * 20ms));
    EXPECT_EQ(seen.odometry.stamp, seen.stamp);
    if (seen.scan) {
      ++scans;
      EXPECT_EQ(seen.scan->stamp, seen.stamp);
    }
    if (!seen.frame) continue;
    ++frames;
    EXPECT_EQ(seen.stamp - seen.frame->frame.stamp, 100ms);
    const world::InstanceImage* instances = simulator.instances_of(seen.frame->frame.stamp);
    ASSERT_NE(instances, nullptr);
    EXPECT_EQ(instances->instances.size(), 160U * 120U);
  }
  EXPECT_EQ(scans, 50);
  EXPECT_EQ(frames, 24);                                     // the 25th is on its way
  EXPECT_EQ(simulator.instances_of(Stamp(200ms)), nullptr);  // only the last 20 are kept
  EXPECT_NE(simulator.instances_of(Stamp(1000ms)), nullptr);
}

TEST(Simulator, TheCameraSeesWhatStandsBeforeItAndNoneOfTheRobot) {
  Worker worker(false);
  Simulator simulator(test::room(5, 4), small_camera_robot(), small_camera_params(), 1, {1, 2, 0}, worker);
  const std::uint16_t id =
      simulator.add_object(test::block("crate", {0.4, 0.4, 0.9}, {0, 0, 0}, false), test::at(3, 2, 0.45), "crate");
  std::optional<robot::CapturedFrame> last;
  for (int i = 0; i < 100; ++i) {
    if (robot::Observation seen = simulator.observe(); seen.frame) last = std::move(seen.frame);
  }
  ASSERT_TRUE(last);
  const world::InstanceImage* instances = simulator.instances_of(last->frame.stamp);
  ASSERT_NE(instances, nullptr);
  const std::size_t middle = 100U * 160U + 80U;  // looks a little down at the crate's face
  EXPECT_EQ(instances->instances[middle], id);
  const double depth_m = 2.8 - 1.0 - last->T_base_camera.position().x();
  EXPECT_NEAR(last->frame.depth_m[middle], depth_m, 0.05);
}

TEST(Simulator, ADriveIntoTheWallIsOneCollisionAndPressesTheBumper) {
  Worker worker(false);
  SimulatorParams params = small_camera_params();
  params.camera_period_s = 10.0;
  Simulator simulator(playroom(), small_camera_robot(), params, 1, {1, 2, 0}, worker);
  simulator.command({{0.0, 0.3}, 0.0, 0.0, 0.0});
  bool bumper = false;
  for (int i = 0; i < 500; ++i) bumper = simulator.observe().bumper;
  EXPECT_TRUE(bumper);
  ASSERT_EQ(simulator.collisions().size(), 1U);
  EXPECT_EQ(simulator.collisions()[0].body, "wall_north");
  EXPECT_NEAR(simulator.truth().T_world_base.y_m, 4.0 - 0.22, 0.02);
}

TEST(Simulator, TruthTellsOfObjectsOnly) {
  Worker worker(false);
  Simulator simulator(playroom(), small_camera_robot(), small_camera_params(), 1, {1, 2, 0.3}, worker);
  const std::uint16_t id =
      simulator.add_object(test::block("book", {0.2, 0.15, 0.03}, {0, 0, 0}, false), test::at(2, 3, 0.2), "hardback");
  for (int i = 0; i < 150; ++i) (void)simulator.observe();
  const world::Truth truth = simulator.truth();
  EXPECT_EQ(truth.stamp, Stamp(3s));
  ASSERT_EQ(truth.objects.size(), 3U);
  EXPECT_EQ(truth.objects[0].name, "brick");
  EXPECT_EQ(truth.objects[2].kind, "hardback");
  EXPECT_EQ(truth.objects[2].instance, id);
  EXPECT_NEAR(truth.objects[2].bounds.min().z(), 0.0, 0.003);
  EXPECT_NEAR(truth.objects[2].bounds.max().z(), 0.03, 0.003);
  EXPECT_EQ(simulator.world_now().bodies.size(), 9U);
  simulator.remove_object("book");
  EXPECT_EQ(simulator.truth().objects.size(), 2U);
  EXPECT_EQ(simulator.world_now().bodies.size(), 8U);
}

TEST(Simulator, TruthTellsOfStaticBodiesThatItIsToldOf) {
  Worker worker(false);
  Simulator simulator(playroom(), small_camera_robot(), small_camera_params(), 1, {1, 2, 0}, worker);
  const std::size_t before = simulator.truth().objects.size();
  simulator.tell_of("cupboard");
  const world::Truth truth = simulator.truth();
  ASSERT_EQ(truth.objects.size(), before + 1);
  const auto cupboard = std::find_if(truth.objects.begin(), truth.objects.end(),
                                     [](const world::ObjectTruth& o) { return o.name == "cupboard"; });
  ASSERT_NE(cupboard, truth.objects.end());
  EXPECT_LT((cupboard->bounds.center() - Eigen::Vector3d(4.7, 3, 0.6)).norm(), 0.05);
  EXPECT_THROW(simulator.tell_of("nobody"), ArgumentError);
}

TEST(Simulator, ScriptedChangesAreChecked) {
  Worker worker(false);
  Simulator simulator(playroom(), small_camera_robot(), small_camera_params(), 1, {1, 2, 0.3}, worker);
  EXPECT_THROW(simulator.add_object(test::block("ball", {1, 1, 1}, {0, 0, 0}), test::at(0, 0, 0), "x"), ArgumentError);
  EXPECT_THROW(simulator.add_object(test::block("new", {1, 1, 1}, {0, 0, 0}), test::at(0, 0, 0), ""), ArgumentError);
  EXPECT_THROW(simulator.move_object("wall_east", test::at(0, 0, 0)), ArgumentError);
  EXPECT_THROW(simulator.remove_object("nobody"), ArgumentError);
}

TEST(Simulator, ParametersAreInTheTable) {
  SimulatorParams params;
  ParamTable table;
  describe(table, params);
  table.set_override("laser.sigma=0.02");
  table.set_override("camera.period=0.5");
  EXPECT_DOUBLE_EQ(params.laser.sigma_m, 0.02);
  EXPECT_DOUBLE_EQ(params.camera_period_s, 0.5);
  EXPECT_THROW(table.set_override("physics.step=1"), ArgumentError);
}

}  // namespace
}  // namespace amiss::sim
