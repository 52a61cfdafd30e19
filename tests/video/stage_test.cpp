#include "video/stage.hpp"

#include <gtest/gtest.h>

#include "video/told_run.hpp"

namespace amiss::video {
namespace {

struct StageOf : testing::Test {
  page::Story story = test::told_run();
  world::World world;
  std::map<std::string, world::Body> kinds;
  robot::Model model = robot::load_model(std::filesystem::path(AMISS_SOURCE_DIR) / "robot_model" / "hsr.urdf");

  StageOf() {
    world::Body floor;
    floor.name = "floor";
    floor.visuals.push_back({world::Plane{Eigen::Vector3d::UnitZ(), {30.0, 30.0}}, Eigen::Isometry3d::Identity(), {}});
    world.bodies.push_back(floor);
    world::Body mug;
    mug.name = "mug";
    mug.visuals.push_back({world::Box{{0.1, 0.1, 0.1}}, Eigen::Isometry3d::Identity(), {}});
    kinds["mug"] = mug;
  }
  /// From 6 m above a point of the map.
  sim::RenderedFrame from_above(Stage& stage, double t_s, const Eigen::Vector3d& p_map) const {
    const Eigen::Vector3d p = story.place.T_world_map.T * p_map;
    return stage.picture(t_s, sim::look_at({p + Eigen::Vector3d(0.0, 0.0, 6.0)}, {p}), sim::pinhole(101, 101, 0.3));
  }
  static double middle_m(const sim::RenderedFrame& frame) { return static_cast<double>(frame.depth_m[50 * 101 + 50]); }
};

TEST_F(StageOf, ShowsTheRobotWhereItWas) {
  Stage stage(world, kinds, model, story);
  EXPECT_LT(middle_m(from_above(stage, 5.0, {1.0, 0.0, 0.0})), 5.4) << "its head or body";
  EXPECT_NEAR(middle_m(from_above(stage, 5.0, {1.0, -1.5, 0.0})), 6.0, 1e-3) << "the floor";
  EXPECT_NEAR(middle_m(from_above(stage, 0.0, {1.5, 0.0, 0.0})), 6.0, 1e-3) << "not there yet";
}

TEST_F(StageOf, ShowsObjectsAsLongAsTheyAreThere) {
  story.bodies.push_back({4.0, {"mug", "", std::nullopt}});
  Stage stage(world, kinds, model, story);
  EXPECT_NEAR(middle_m(from_above(stage, 1.0, {1.0, 1.0, 0.0})), 5.9, 1e-3);
  EXPECT_NEAR(middle_m(from_above(stage, 5.0, {1.0, 1.0, 0.0})), 6.0, 1e-3) << "it is gone";
}

TEST_F(StageOf, ShowsADoorOfTheWorldOnceWhereItWasClosed) {
  world::Body door;  // static in the world's file, unfixed by the script; its kind is its name
  door.name = "door_leaf_1";
  door.is_static = true;
  door.pose.T.translate(Eigen::Vector3d(5.0, 4.0, 0.0));  // of the world: the origin of the map
  door.visuals.push_back({world::Box{{0.5, 0.5, 0.5}}, Eigen::Isometry3d::Identity(), {}});
  world.bodies.push_back(door);
  Transform<Map, Object> T_map_door;
  T_map_door.T.translate(Eigen::Vector3d(0.0, 2.0, 0.0));
  story.bodies.insert(story.bodies.begin(), {0.0, {"door_leaf_1", "door_leaf_1", T_map_door}});
  for (auto& [t, pose] : story.poses) pose.truth = {0.0, -2.0, 0.0};
  Stage stage(world, kinds, model, story);
  EXPECT_NEAR(middle_m(from_above(stage, 1.0, {0.0, 0.0, 0.0})), 6.0, 1e-3) << "not where the file has it";
  EXPECT_NEAR(middle_m(from_above(stage, 1.0, {0.0, 2.0, 0.0})), 5.75, 1e-3);
}

TEST_F(StageOf, ShowsWhoWalksAndLeavesOutWhatIsUnknown) {
  kinds["person"] = kinds["mug"];
  Transform<Map, Object> T_map_anna;
  T_map_anna.T.translate(Eigen::Vector3d(0.0, 2.0, 0.05));
  story.bodies.push_back({2.0, {"anna", "person", T_map_anna}});
  story.bodies.push_back({2.0, {"thing", "of_nobody", T_map_anna}});
  T_map_anna.T.translate(Eigen::Vector3d(0.0, 0.5, 0.0));
  story.bodies.push_back({4.0, {"anna", "person", T_map_anna}});
  Stage stage(world, kinds, model, story);
  EXPECT_NEAR(middle_m(from_above(stage, 1.0, {0.0, 2.0, 0.0})), 6.0, 1e-3) << "not there yet";
  EXPECT_NEAR(middle_m(from_above(stage, 3.0, {0.0, 2.0, 0.0})), 5.9, 1e-3);
  EXPECT_NEAR(middle_m(from_above(stage, 5.0, {0.0, 2.0, 0.0})), 6.0, 1e-3) << "walked on";
  EXPECT_NEAR(middle_m(from_above(stage, 5.0, {0.0, 2.5, 0.0})), 5.9, 1e-3);
}

TEST_F(StageOf, HasAllLinksOfTheRobot) {
  const auto bodies = link_bodies(model);
  ASSERT_EQ(bodies.size(), model.links.size());
  std::size_t shapes = 0;
  for (const auto& body : bodies) shapes += body.visuals.size();
  EXPECT_GT(shapes, 10U);
}

}  // namespace
}  // namespace amiss::video
