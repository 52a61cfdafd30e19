#include "sim/physics.hpp"

#include <gtest/gtest.h>

#include "sim/rooms.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;
using test::block;
using test::body;

void let_pass(Physics& physics, double time_s) {
  for (int i = 0; i < static_cast<int>(time_s * 50); ++i) physics.step(20ms);
}

std::shared_ptr<const world::Mesh> tetrahedron(float edge) {
  auto mesh = std::make_shared<world::Mesh>();
  mesh->vertices = {{0, 0, 0}, {edge, 0, 0}, {0, edge, 0}, {0, 0, edge}};
  mesh->indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return mesh;
}

/// A square of two triangles at z = 0, as floors of scanned houses are.
std::shared_ptr<const world::Mesh> square(float edge) {
  auto mesh = std::make_shared<world::Mesh>();
  mesh->vertices = {{0, 0, 0}, {edge, 0, 0}, {edge, edge, 0}, {0, edge, 0}};
  mesh->indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

struct Falling {
  std::string name;
  world::Geometry geometry;
  double rest_z;
};

class Falls : public testing::TestWithParam<Falling> {};

TEST_P(Falls, AndRestsAtTheRightHeight) {
  world::World world = test::room(4, 4);
  world.bodies.push_back(body("thing", GetParam().geometry, {2, 2, GetParam().rest_z + 0.1}, false));
  Physics physics(world);
  let_pass(physics, 6.0);
  EXPECT_TRUE(physics.all_asleep());
  EXPECT_NEAR(physics.pose(5).position().z(), GetParam().rest_z, 0.002);
  EXPECT_NEAR(physics.bounds(5).min().z(), 0.0, 0.002);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Falls,
    testing::Values(Falling{"box", world::Box{{0.06, 0.16, 0.21}}, 0.105},
                    Falling{"thin_box", world::Box{{0.1, 0.1, 0.01}}, 0.005},
                    Falling{"can", world::Cylinder{0.033, 0.1}, 0.05}, Falling{"ball", world::Sphere{0.04}, 0.04},
                    Falling{"hull", world::MeshInstance{tetrahedron(0.1F), {1, 1, 1}}, 0.0},
                    Falling{"small_hull", world::MeshInstance{tetrahedron(0.1F), {0.3, 0.3, 0.3}}, 0.0}),
    [](const auto& which) { return which.param.name; });

TEST(Physics, ThingsRestOnPlanesAndOnMeshes) {
  world::World world;
  world.bodies.push_back(body("plane", world::Plane{{0, 0, 1}, {1, 1}}, {0, 0, 0}, true));
  world.bodies.push_back(body("mesh", world::MeshInstance{square(2.0F), {2, 2, 1}}, {-2, -2, 0.5}, true));
  world.bodies.push_back(block("on_plane", {0.1, 0.1, 0.1}, {5, 5, 0.2}, false));
  world.bodies.push_back(block("on_mesh", {0.1, 0.1, 0.1}, {1, 1, 0.7}, false));
  Physics physics(world);
  let_pass(physics, 5.0);
  EXPECT_NEAR(physics.pose(2).position().z(), 0.05, 0.002);
  EXPECT_NEAR(physics.pose(3).position().z(), 0.55, 0.002);
}

TEST(Physics, ABallRollsAndStops) {
  world::World world = test::room(6, 4);
  // A ramp at one end sets it off.
  world::Body ramp = block("ramp", {0.5, 0.5, 0.02}, {0.5, 2, 0.1});
  ramp.pose.T.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()));
  world.bodies.push_back(ramp);
  world.bodies.push_back(body("ball", world::Sphere{0.05}, {0.45, 2, 0.2}, false));
  Physics physics(world);
  let_pass(physics, 30.0);
  EXPECT_TRUE(physics.all_asleep());
  EXPECT_GT(physics.pose(6).position().x(), 1.0);
  EXPECT_NEAR(physics.pose(6).position().z(), 0.05, 0.002);
}

TEST(Physics, WhatStoodOnSomethingFallsWhenThatIsGone) {
  world::World world = test::room(4, 4);
  world.bodies.push_back(block("table", {1, 1, 0.5}, {2, 2, 0.25}));
  world.bodies.push_back(block("cup", {0.1, 0.1, 0.1}, {2, 2, 0.55}, false));
  Physics physics(world);
  let_pass(physics, 4.0);
  ASSERT_TRUE(physics.all_asleep());
  physics.remove(5);
  EXPECT_FALSE(physics.is_present(5));
  let_pass(physics, 4.0);
  EXPECT_NEAR(physics.pose(6).position().z(), 0.05, 0.002);
  physics.place(6, test::at(1, 1, 0.3));
  let_pass(physics, 4.0);
  EXPECT_NEAR(physics.pose(6).position().z(), 0.05, 0.002);
  EXPECT_NEAR(physics.pose(6).position().x(), 1.0, 0.002);
}

TEST(Physics, WhatIsWedgedInFixedThingsRestsUntilItIsMoved) {
  world::World world = test::room(4, 4);
  world.bodies.push_back(block("frame", {0.5, 0.5, 0.5}, {2, 2, 0.25}));
  world.bodies.push_back(block("drawer", {0.4, 0.6, 0.2}, {2, 1.9, 0.3}, false));
  Physics physics(world);
  EXPECT_TRUE(physics.all_asleep());
  let_pass(physics, 1.0);
  EXPECT_EQ(physics.pose(6).position(), Eigen::Vector3d(2, 1.9, 0.3));
  physics.place(6, test::at(1, 1, 0.3));
  let_pass(physics, 3.0);
  EXPECT_NEAR(physics.pose(6).position().z(), 0.1, 0.002);
}

TEST(Physics, DistanceToFurnitureIsThatOfTheSurfaces) {
  world::World world = test::room(4, 4);
  world.bodies.push_back(block("box", {0.1, 0.2, 0.1}, {0.35, 2, 0.05}, false));
  Physics physics(world);
  const std::optional<double> near = physics.distance_to_others(5, 0.5);
  ASSERT_TRUE(near);
  EXPECT_NEAR(*near, 0.30, 0.001);  // to the west wall; the floor does not count
  EXPECT_FALSE(physics.distance_to_others(5, 0.2));
}

TEST(Physics, RaysMeetTheNearestBody) {
  const Physics physics(test::room(4, 3));
  const auto hit = physics.cast_ray({{1, 1, 1}}, {{9, 1, 1}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 3.0, 1e-6);
  EXPECT_EQ(physics.name(hit->body), "wall_east");
  EXPECT_FALSE(physics.cast_ray({{1, 1, 5}}, {{9, 1, 5}}));
}

TEST(Physics, SamePastSamePresent) {
  world::World world = test::room(3, 3);
  for (int i = 0; i < 12; ++i) {
    world.bodies.push_back(
        block("b" + std::to_string(i), {0.1, 0.12, 0.14}, {1.5 + 0.01 * i, 1.5, 0.2 + 0.2 * i}, false));
  }
  Physics a(world), b(world);
  let_pass(a, 5.0);
  let_pass(b, 5.0);
  for (std::size_t i = 0; i < a.body_count(); ++i) EXPECT_EQ(a.pose(i).T.matrix(), b.pose(i).T.matrix());
}

}  // namespace
}  // namespace amiss::sim
