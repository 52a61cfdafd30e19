#include "sim/placer.hpp"

#include <gtest/gtest.h>

#include <set>

#include "sim/furnished.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;

class PlacerTest : public ::testing::Test {
 protected:
  /// Checked anew in a world that holds all objects: they rest where they are said to be.
  void expect_at_rest(const std::vector<ScatteredObject>& objects) const {
    Physics physics(test::with_objects(world_, objects, catalogue_));
    for (int i = 0; i < 100; ++i) physics.step(20ms);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Eigen::Vector3d moved = physics.pose(world_.bodies.size() + i).position() - objects[i].pose.position();
      EXPECT_LT(moved.norm(), 0.02) << objects[i].name;
    }
  }
  /// Bounds of the objects as they lie.
  [[nodiscard]] std::vector<Eigen::AlignedBox3d> boxes(const std::vector<ScatteredObject>& objects) const {
    const Physics physics(test::with_objects(world_, objects, catalogue_));
    std::vector<Eigen::AlignedBox3d> found;
    for (std::size_t i = 0; i < objects.size(); ++i) found.push_back(physics.bounds(world_.bodies.size() + i));
    return found;
  }

  world::World world_ = test::furnished_room();
  world::Catalogue catalogue_ = test::toys();
  RandomStream random_{7, "test/placer"};
};

TEST_F(PlacerTest, FreeObjectsLieOnSurfacesAndRest) {
  Placer placer(world_, {});
  std::set<double> levels;
  for (const auto& entry : catalogue_.entries) {
    EXPECT_TRUE(placer.place(entry.name, entry.name, entry.body, Manner::kFree, random_)) << entry.name;
  }
  const auto objects = placer.objects();
  ASSERT_EQ(objects.size(), catalogue_.entries.size());
  const std::vector<Support> supports = find_supports(world_);
  for (const Eigen::AlignedBox3d& box : boxes(objects)) {
    const auto under = support_under(supports, foot_of(box));
    ASSERT_TRUE(under) << foot_of(box).transpose();
    levels.insert(under->height_m());
  }
  EXPECT_GE(levels.size(), 2U);
  expect_at_rest(objects);
}

TEST_F(PlacerTest, PushedObjectsTouchSomethingAndHeapsTouchEachOther) {
  Placer placer(world_, {});
  const auto& carton = catalogue_.at("carton");
  ASSERT_TRUE(placer.place("carton", "carton", carton.body, Manner::kAgainst, random_));
  Physics physics(test::with_objects(world_, placer.objects(), catalogue_));
  const auto gap_m = physics.distance_to_others(world_.bodies.size(), 0.03);
  const bool on_rim = boxes(placer.objects())[0].sizes().norm() > 0.0 && !gap_m;  // pushed to the edge instead
  EXPECT_TRUE(gap_m || on_rim);

  ASSERT_TRUE(placer.place("brick", "brick", catalogue_.at("brick").body, Manner::kHeap, random_));
  const auto found = boxes(placer.objects());
  EXPECT_LT(found[0].exteriorDistance(found[1]), 0.2);
  EXPECT_GT(found[1].min().z(), 0.4);
  expect_at_rest(placer.objects());
}

TEST_F(PlacerTest, NothingIsPlacedWhereNoEyeSeesIt) {
  // From this eye the upper board hides the lower one, and all else is too far.
  PlacerParams params;
  params.seen_within_m = 1.0;
  params.tries = 40;
  Placer placer(world_, {{Eigen::Vector3d(3.0, 3.6, 1.7)}}, params);
  for (const char* kind : {"can", "cube", "mug"}) {
    ASSERT_TRUE(placer.place(kind, kind, catalogue_.at(kind).body, Manner::kFree, random_));
  }
  for (const Eigen::AlignedBox3d& box : boxes(placer.objects())) EXPECT_NEAR(box.min().z(), 0.90, 0.02);
  Placer blind(world_, {{Eigen::Vector3d(2.0, 2.0, 5.0)}}, params);
  EXPECT_FALSE(blind.place("can", "can", catalogue_.at("can").body, Manner::kFree, random_));
  EXPECT_TRUE(blind.objects().empty());
}

TEST_F(PlacerTest, KeepsWhatStaysAndRefusesWhatWouldFall) {
  Placer placer(world_, {});
  ScatteredObject cube{"cube", "cube", {}};
  cube.pose.T.translation() = Eigen::Vector3d(2.2, 0.65, 0.78);
  EXPECT_TRUE(placer.keep(cube, catalogue_.at("cube").body));
  ScatteredObject floating{"mug", "mug", {}};
  floating.pose.T.translation() = Eigen::Vector3d(2.0, 2.0, 1.0);
  EXPECT_FALSE(placer.keep(floating, catalogue_.at("mug").body));
  ScatteredObject inside{"can", "can", {}};
  inside.pose.T.translation() = Eigen::Vector3d(1.8, 0.65, 0.95);  // in the monitor
  EXPECT_FALSE(placer.keep(inside, catalogue_.at("can").body));
  ASSERT_EQ(placer.objects().size(), 1U);
  EXPECT_LT((placer.objects()[0].pose.position() - cube.pose.position()).norm(), 0.01);
  EXPECT_FALSE(Placer(test::room(3, 3), {}).place("can", "can", catalogue_.at("can").body, Manner::kFree, random_));
}

TEST_F(PlacerTest, WhatSlipsOffALowThingDoesNotStayAndHindersNothing) {
  world_.bodies.push_back(test::block("board_1", {0.3, 0.3, 0.03}, {2.2, 0.95, 0.765}));
  Placer placer(world_, {});
  ScatteredObject brick{"brick", "brick", {}};  // tilted over the edge of the board
  brick.pose.T.translation() = Eigen::Vector3d(2.345, 0.95, 0.8192);
  brick.pose.T.rotate(Eigen::AngleAxisd(radians(-15.0), Eigen::Vector3d::UnitY()));
  EXPECT_FALSE(placer.keep(brick, catalogue_.at("brick").body)) << "it comes to lie beside the board, 3 cm lower";
  EXPECT_TRUE(placer.objects().empty());
  EXPECT_TRUE(placer.place("can", "can", catalogue_.at("can").body, Manner::kFree, random_));
}

}  // namespace
}  // namespace amiss::sim
