#include "sim/scatter.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "core/result.hpp"
#include "sim/physics.hpp"
#include "sim/rooms.hpp"
#include "world/loader.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;

world::CatalogueEntry entry(const std::string& name, const world::Geometry& geometry) {
  return {name, name, test::body(name, geometry, {0, 0, 0}, false), {}};
}

world::Catalogue toys() {
  world::Catalogue catalogue;
  catalogue.entries = {entry("ball", world::Sphere{0.05}), entry("brick", world::Box{{0.1, 0.06, 0.05}}),
                       entry("can", world::Cylinder{0.033, 0.12}), entry("carton", world::Box{{0.06, 0.16, 0.21}}),
                       entry("plate", world::Cylinder{0.1, 0.02})};
  return catalogue;
}

/// Two rooms joined by a door of 0.9 m, with a table and a cupboard.
world::World two_rooms() {
  world::World world = test::room(6, 4);
  world.bodies.push_back(test::block("wall_a", {0.1, 1.5, 2.5}, {3, 0.75, 1.25}));
  world.bodies.push_back(test::block("wall_b", {0.1, 1.6, 2.5}, {3, 3.2, 1.25}));
  world.bodies.push_back(test::block("table_top", {1.2, 0.8, 0.04}, {1.2, 3.2, 0.72}));
  world.bodies.push_back(test::block("cupboard", {0.5, 1.0, 1.8}, {5.7, 1, 0.9}));
  world.bodies.push_back(test::block("chair", {0.4, 0.4, 0.9}, {4.5, 3.2, 0.45}, false));
  return world;
}

/// All that a scattered object promises, checked anew in a world that holds them all.
void expect_contract(const std::vector<ScatteredObject>& objects, const world::Catalogue& catalogue,
                     const world::World& world, const Pose2<amiss::World, Base>& start) {
  world::World full = world;
  for (const ScatteredObject& object : objects) {
    full.bodies.push_back(catalogue.at(object.kind).body);
    full.bodies.back().name = object.name;
    full.bodies.back().pose = object.pose;
  }
  Physics physics(full);
  for (int i = 0; i < 200; ++i) physics.step(20ms);
  const FloorGrid above = floor_plan(world, 0.02, 0.3, 1.2, false);
  std::vector<Eigen::Vector2d> middles;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::size_t body = world.bodies.size() + i;
    const Eigen::AlignedBox3d box = physics.bounds(body);
    EXPECT_LT((physics.pose(body).position() - objects[i].pose.position()).norm(), 0.01) << objects[i].name << " rests";
    EXPECT_NEAR(box.min().z(), 0.0, 0.013) << objects[i].name;
    EXPECT_FALSE(physics.distance_to_others(body, 0.097)) << objects[i].name;
    const Eigen::Vector2d middle = box.center().head<2>();
    EXPECT_NE(above.at(middle), Occupancy::kOccupied) << objects[i].name << " lies under something";
    EXPECT_GE((middle - start.position()).norm(), 0.79);
    for (const Eigen::Vector2d& other : middles) EXPECT_GE((middle - other).norm(), 0.49);
    middles.push_back(middle);
  }
  // With all of them there, the robot still comes near each.
  const FloorGrid room = standing_room(floor_plan(full, 0.05, 0.02, 1.1, true), 0.28);
  const std::vector<int> labels = connected_areas(room);
  const int own = labels[room.index(room.cell_at(start.position()))];
  ASSERT_NE(own, 0);
  for (const Eigen::Vector2d& p : middles) {
    bool near = false;
    for (int y = 0; y < room.height(); ++y) {
      for (int x = 0; x < room.width(); ++x) {
        near |= labels[room.index({x, y})] == own && (room.centre_of({x, y}) - p).norm() < 0.75;
      }
    }
    EXPECT_TRUE(near);
  }
}

TEST(Scatter, KeepsItsPromises) {
  const Pose2<amiss::World, Base> start{1.5, 1.5, 0};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto objects = scatter(7, toys(), two_rooms(), test::small_robot(), start, RandomStream(seed, "scatter"));
    ASSERT_EQ(objects.size(), 7U);
    std::set<std::string> kinds, names;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (i < 5) kinds.insert(objects[i].kind);
      names.insert(objects[i].name);
    }
    EXPECT_EQ(names.size(), 7U);
    EXPECT_GE(kinds.size(), 4U);  // distinct while the catalogue lasts, unless a kind found no place
    expect_contract(objects, toys(), two_rooms(), start);
  }
}

TEST(Scatter, SameSeedSamePlaces) {
  const auto places = [](std::uint64_t seed) {
    return scatter(3, toys(), two_rooms(), test::small_robot(), {1.5, 1.5, 0}, RandomStream(seed, "scatter"));
  };
  const auto a = places(3), b = places(3), c = places(4);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].kind, b[i].kind);
    EXPECT_EQ(a[i].pose.T.matrix(), b[i].pose.T.matrix());
  }
  EXPECT_NE(a[0].pose.T.matrix(), c[0].pose.T.matrix());
}

TEST(Scatter, NothingLiesWhereTheRobotCannotCome) {
  world::World world = two_rooms();
  world.bodies.push_back(test::block("shut_door", {0.1, 0.9, 2}, {3, 1.95, 1}));
  for (const auto& object : scatter(3, toys(), world, test::small_robot(), {1.5, 1.5, 0}, RandomStream(1, "scatter"))) {
    EXPECT_LT(object.pose.position().x(), 3.0);
  }
}

TEST(Scatter, TooManyAndNoPlaceToStandAreErrors) {
  const world::World small = test::room(1.5, 1.5);
  EXPECT_THROW((void)scatter(9, toys(), small, test::small_robot(), {0.75, 0.75, 0}, RandomStream(1, "s")), InputError);
  EXPECT_THROW((void)scatter(1, toys(), two_rooms(), test::small_robot(), {5.7, 1, 0}, RandomStream(1, "s")),
               InputError);
  EXPECT_THROW((void)scatter(1, {}, small, test::small_robot(), {0.75, 0.75, 0}, RandomStream(1, "s")), InputError);
  EXPECT_TRUE(scatter(0, {}, small, test::small_robot(), {}, RandomStream(1, "s")).empty());
}

class OwnWorlds : public testing::TestWithParam<const char*> {};

TEST_P(OwnWorlds, AreScatteredWell) {
  const std::filesystem::path root = AMISS_SOURCE_DIR;
  const std::filesystem::path sdf = root / "sim_worlds" / (std::string(GetParam()) + ".sdf");
  if (!std::filesystem::exists(sdf) || !std::filesystem::exists(root / "robot_model/hsr.urdf")) GTEST_SKIP();
  const world::World world = world::load_world(sdf);
  const robot::Model model = robot::load_model(root / "robot_model/hsr.urdf");
  const auto start = world.robot_start.value_or(free_start(world, model));
  const auto objects = scatter(7, toys(), world, model, start, RandomStream(1, "scatter"));
  expect_contract(objects, toys(), world, start);
}

INSTANTIATE_TEST_SUITE_P(Worlds, OwnWorlds, testing::Values("lab_30", "flat_90"),
                         [](const auto& which) { return std::string(which.param); });

class ScatterFile : public testing::Test {
 protected:
  std::filesystem::path file_ = std::filesystem::temp_directory_path() /
                                ("amiss_scatter_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ".yaml");
  void TearDown() override { std::filesystem::remove(file_); }
  void write(const std::string& text) const { std::ofstream(file_) << text; }
  std::string error_of(const std::string& text) const {
    write(text);
    try {
      (void)load_scatter(file_, toys());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ScatterFile, WhatIsSavedComesBack) {
  const auto objects = scatter(5, toys(), two_rooms(), test::small_robot(), {1.5, 1.5, 0}, RandomStream(9, "scatter"));
  save_scatter(file_, objects);
  const auto again = load_scatter(file_, toys());
  ASSERT_EQ(again.size(), objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    EXPECT_EQ(again[i].kind, objects[i].kind);
    EXPECT_EQ(again[i].name, objects[i].name);
    EXPECT_LT((again[i].pose.T.matrix() - objects[i].pose.T.matrix()).norm(), 1e-9);
  }
  save_scatter(file_, {});
  EXPECT_TRUE(load_scatter(file_, toys()).empty());
}

TEST_F(ScatterFile, WithoutAHeightThingsStandOnTheFloor) {
  write("- {object: can, x: 1, y: 2}\n- {object: can, x: 2, y: 2, roll_deg: 90}\n");
  const auto objects = load_scatter(file_, toys());
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_NEAR(objects[0].pose.position().z(), 0.06, 1e-6);
  EXPECT_NEAR(objects[1].pose.position().z(), 0.033, 1e-6);
  EXPECT_EQ(objects[0].name, "can");
  EXPECT_EQ(objects[1].name, "can_2");
}

TEST_F(ScatterFile, ErrorsNameTheLineAndWhatIsAllowed) {
  EXPECT_NE(error_of("- {object: can, x: 1, y: 2}\n- {object: cann, x: 1, y: 2}\n").find(":2: no object 'cann'"),
            std::string::npos);
  EXPECT_NE(error_of("- {object: cann, x: 1, y: 2}\n").find("did you mean 'can'"), std::string::npos);
  EXPECT_NE(error_of("- {object: can, x: 1}\n").find("y is missing"), std::string::npos);
  EXPECT_NE(error_of("- {object: can, x: 1, y: .nan}\n").find("y is not a number"), std::string::npos);
  EXPECT_NE(error_of("- {object: can, x: 1, y: 1, yaw: 3}\n").find("unknown key 'yaw'"), std::string::npos);
  EXPECT_NE(error_of("object: can\n").find("not a list"), std::string::npos);
  EXPECT_NE(error_of("- [1, 2\n").find("not YAML"), std::string::npos);
  EXPECT_NE(error_of("- {object: can, x: 1, y: 2, name: a}\n- {object: can, x: 1, y: 2, name: a}\n").find("twice"),
            std::string::npos);
  EXPECT_THROW((void)load_scatter("no_such_file.yaml", toys()), InputError);
}

}  // namespace
}  // namespace amiss::sim
