#include "video/stage.hpp"

#include <gtest/gtest.h>

#include "video/told_run.hpp"

namespace amiss::video {
namespace {

struct StageOf : testing::Test {
  page::Story story = test::told_run();
  world::World world;
  world::Catalogue catalogue;
  robot::Model model = robot::load_model(std::filesystem::path(AMISS_SOURCE_DIR) / "robot_model" / "hsr.urdf");

  StageOf() {
    world::Body floor;
    floor.name = "floor";
    floor.visuals.push_back({world::Plane{Eigen::Vector3d::UnitZ(), {30.0, 30.0}}, Eigen::Isometry3d::Identity(), {}});
    world.bodies.push_back(floor);
    world::Body mug;
    mug.name = "mug";
    mug.visuals.push_back({world::Box{{0.1, 0.1, 0.1}}, Eigen::Isometry3d::Identity(), {}});
    catalogue.entries.push_back({"mug", "mug", mug, {0.1, 0.1, 0.1}});
  }
  /// From 6 m above a point of the map.
  sim::RenderedFrame from_above(Stage& stage, double t_s, const Eigen::Vector3d& p_map) const {
    const Eigen::Vector3d p = story.place.T_world_map.T * p_map;
    return stage.picture(t_s, sim::look_at({p + Eigen::Vector3d(0.0, 0.0, 6.0)}, {p}), sim::pinhole(101, 101, 0.3));
  }
  static double middle_m(const sim::RenderedFrame& frame) { return static_cast<double>(frame.depth_m[50 * 101 + 50]); }
};

TEST_F(StageOf, ShowsTheRobotWhereItWas) {
  Stage stage(world, catalogue, model, story);
  EXPECT_LT(middle_m(from_above(stage, 5.0, {1.0, 0.0, 0.0})), 5.4) << "its head or body";
  EXPECT_NEAR(middle_m(from_above(stage, 5.0, {1.0, -1.5, 0.0})), 6.0, 1e-3) << "the floor";
  EXPECT_NEAR(middle_m(from_above(stage, 0.0, {1.5, 0.0, 0.0})), 6.0, 1e-3) << "not there yet";
}

TEST_F(StageOf, ShowsObjectsAsLongAsTheyAreThere) {
  story.bodies.push_back({4.0, {"mug", "", std::nullopt}});
  Stage stage(world, catalogue, model, story);
  EXPECT_NEAR(middle_m(from_above(stage, 1.0, {1.0, 1.0, 0.0})), 5.9, 1e-3);
  EXPECT_NEAR(middle_m(from_above(stage, 5.0, {1.0, 1.0, 0.0})), 6.0, 1e-3) << "it is gone";
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
