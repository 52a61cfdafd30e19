// Read back by MRPT's own reader, as SceneViewer3D does it.
#include "page/scene_file.hpp"

#include <gtest/gtest.h>
#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CText.h>

#include <array>

#include "core/temporary_folder.hpp"
#include "video/told_run.hpp"

namespace amiss::page {
namespace {

namespace gl = mrpt::opengl;
constexpr double kMillimetre = 1e-3;

/// In the voxels of 5 cm: two of the reference only, one that both hold, one that appeared and one that vanished.
Story story_with_voxels() {
  Story story = test::told_run();
  story.resolution_m = 0.05;
  story.reference = {{0, 0, 0}, {5, 0, 0}, {6, 0, 0}, {8, 0, 0}};
  story.voxels = {{1.0, {{{0, 0, 0}, {20, 20, 1}, {30, 0, 0}}, {}}}, {4.0, {{}, {{30, 0, 0}}}}};
  story.differences = {{4.0, {{{20, 20, 1}}, {{8, 0, 0}}}}};
  story.views = {{1.0, {{1, {0.5, -0.5, 0.0}, 1.0, 2.0, false, false}, {2, {}, 1.0, 2.0, false, true}}}};
  story.segments = {{6.0, {{{Eigen::Vector3d(1.0, 1.0, 0.05)}, {0.1, 0.08, 0.1}, 0.7}}}};
  story.regions.back().value[0].z_high_m = 0.2;
  story.robot.shapes = {{StoryRobot::Part::kBody, StoryRobot::Kind::kCylinder, {0.2, 0.5, 0.0}, {}, {1, 0, 0}},
                        {StoryRobot::Part::kTilt, StoryRobot::Kind::kBox, {0.1, 0.2, 0.3}, {}, {0, 1, 0}}};
  for (auto& shape : story.robot.shapes) shape.T_base_shape.setIdentity();
  return story;
}

struct SceneFile : testing::Test {
  test::TemporaryFolder folder;
  gl::COpenGLScene scene;

  void read(const Story& story, double t_s) {
    const auto file = folder.path() / "a.3Dscene";
    save_scene(file, scene_bytes(story, t_s));
    ASSERT_TRUE(scene.loadFromFile(file.string()));
    ASSERT_TRUE(scene.getViewport());
  }
  template <class Thing>
  std::shared_ptr<Thing> thing(const std::string& name) {
    return std::dynamic_pointer_cast<Thing>(scene.getByName(name));
  }
  std::size_t voxels(const std::string& name) {
    const auto set = thing<gl::COctoMapVoxels>(name);
    return set ? set->getVoxelCount(0) : 999;
  }
};

TEST_F(SceneFile, HasEveryVoxelOnceAndWhereItIs) {
  read(story_with_voxels(), 10.0);
  EXPECT_EQ(voxels("reference map"), 2U);
  EXPECT_EQ(voxels("map now"), 1U);
  EXPECT_EQ(voxels("vanished"), 1U);
  ASSERT_EQ(voxels("appeared"), 1U);
  const auto& voxel = thing<gl::COctoMapVoxels>("appeared")->getVoxel(0, 0);
  EXPECT_NEAR(static_cast<double>(voxel.coords.x), 1.025, kMillimetre);
  EXPECT_NEAR(static_cast<double>(voxel.coords.y), 1.025, kMillimetre);
  EXPECT_NEAR(static_cast<double>(voxel.coords.z), 0.075, kMillimetre);
  EXPECT_DOUBLE_EQ(voxel.side_length, 0.05);
  EXPECT_GT(voxel.color.R, voxel.color.B) << "orange";
}

TEST_F(SceneFile, ShowsAnInstant) {
  read(story_with_voxels(), 2.5);
  EXPECT_EQ(voxels("map now"), 3U);
  EXPECT_EQ(voxels("appeared"), 0U);
  EXPECT_TRUE(thing<gl::CText>("O1")) << "not examined yet";
  EXPECT_TRUE(thing<gl::CText>("M mug"));
  EXPECT_TRUE(thing<gl::CSetOfObjects>("segments")->empty());
  EXPECT_NEAR(scene.getByName("robot")->getPoseX(), 0.5, kMillimetre);
}

TEST_F(SceneFile, PutsRegionsObjectsViewsAndRobotWhereTheyAre) {
  read(story_with_voxels(), 10.0);
  const auto region = thing<gl::CCylinder>("region 1");
  ASSERT_TRUE(region);
  EXPECT_NEAR(region->getPoseX(), 1.0, kMillimetre);
  EXPECT_NEAR(region->getPoseY(), 1.0, kMillimetre);
  EXPECT_NEAR(static_cast<double>(region->getTopRadius()), 0.3, kMillimetre);
  EXPECT_NEAR(static_cast<double>(region->getHeight()), 0.2, kMillimetre);
  ASSERT_TRUE(thing<gl::CText>("E1"));
  const auto object = scene.getByName("object mug");
  ASSERT_TRUE(object);
  EXPECT_NEAR(object->getPoseX(), 1.0, kMillimetre);
  EXPECT_NEAR(object->getPoseZ(), 0.05, kMillimetre);
  ASSERT_TRUE(thing<gl::CText>("F mug"));
  EXPECT_EQ(thing<gl::CText>("F mug")->getString(), "F mug");
  const auto segments = thing<gl::CSetOfObjects>("segments");
  ASSERT_EQ(segments->size(), 1U);
  EXPECT_NEAR((*segments->begin())->getPoseYawRad(), 0.7, kMillimetre);
  const auto view = thing<gl::CSetOfLines>("view 1");
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->getBoundingBox().max.x, 2.5, kMillimetre) << "2 m high, along x";
  EXPECT_FALSE(thing<gl::CSetOfLines>("view 2")) << "dropped";
  const auto robot = thing<gl::CSetOfObjects>("robot");
  EXPECT_NEAR(robot->getPoseX(), 2.0, kMillimetre);
  ASSERT_EQ(robot->size(), 2U);
  EXPECT_NEAR((*robot->begin())->getPoseZ(), -0.25, kMillimetre) << "MRPT's cylinders stand on their origin";
}

TEST_F(SceneFile, FloorHasASquareForEachKnownCell) {
  Story story = story_with_voxels();
  story.floor.set({0, 0}, Occupancy::kUnknown);
  read(story, 10.0);
  EXPECT_EQ(thing<gl::CSetOfTriangles>("floor plan")->getTrianglesCount(), 2U * (60 * 60 - 1));
  const auto box = thing<gl::CSetOfTriangles>("floor plan")->getBoundingBox();
  EXPECT_NEAR(box.min.x, -2.0, kMillimetre);
  EXPECT_NEAR(box.max.y, 3.0, kMillimetre);
  EXPECT_GT(thing<gl::CSetOfLines>("grid")->size(), 0U);
  const auto driven = thing<gl::CSetOfTriangles>("driven")->getBoundingBox();
  EXPECT_NEAR(driven.max.x, 2.0, kMillimetre);
  EXPECT_NEAR(driven.max.y - driven.min.y, 0.04, kMillimetre);
}

TEST_F(SceneFile, IsAFunctionOfItsInputAndWhole) {
  const Story story = story_with_voxels();
  EXPECT_EQ(scene_bytes(story, 10.0), scene_bytes(story, 10.0));
  EXPECT_THROW(save_scene(folder.path() / "nowhere" / "a.3Dscene", "bytes"), std::exception);
}

TEST_F(SceneFile, HasThePointsOfARoomInTheirColours) {
  Cloud<Map> cloud;
  cloud.points = {{1.0F, 2.0F, 3.0F}, {-1.0F, 0.5F, 0.25F}};
  cloud.colours = {{255, 0, 0}, {10, 20, 30}};
  save_scene(folder.path() / "a.3Dscene", scene_bytes(cloud, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}));
  ASSERT_TRUE(scene.loadFromFile((folder.path() / "a.3Dscene").string()));
  const auto points = thing<gl::CPointCloudColoured>("points");
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 2U);
  EXPECT_EQ(points->getPoint3Df(1).z, 0.25F);
  const auto colour = points->getPointColor(1);
  EXPECT_EQ((std::array{colour.R, colour.G, colour.B}), (std::array<std::uint8_t, 3>{10, 20, 30}));
  EXPECT_EQ(thing<gl::CSetOfLines>("camera")->size(), 2U);
}

TEST_F(SceneFile, ARunWithNothingToTellIsAFloorAndARobot) {
  Story story = test::told_run();
  story.resolution_m = 0.05;
  story.regions.clear();
  story.objects.clear();
  story.floor = {};
  read(story, 0.0);
  EXPECT_EQ(voxels("map now"), 0U);
  EXPECT_TRUE(scene.getByName("robot"));
}

}  // namespace
}  // namespace amiss::page
