#include "semantics/class_votes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/result.hpp"

namespace amiss::semantics {
namespace {

/// A wall 1 m before the camera, its left half a door; the camera looks along x of the map.
RgbdFrame wall_frame() {
  RgbdFrame frame;
  frame.intrinsics = {40, 30, 40.0, 40.0, 19.5, 14.5};
  frame.depth_m.assign(40 * 30, 1.0F);
  frame.colour.resize(40 * 30);
  return frame;
}
std::vector<SemanticClass> half_door() {
  std::vector<SemanticClass> classes(40 * 30, SemanticClass::kWall);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (i % 40 < 20) classes[i] = SemanticClass::kDoor;
  }
  return classes;
}
Transform<Map, Camera> along_x() {
  Transform<Map, Camera> pose;
  pose.T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  pose.T.translation() = Eigen::Vector3d(0, 0, 1);
  return pose;
}

TEST(ClassVotes, PixelsVoteWhereTheyLie) {
  ClassVotes votes(VoteParams{.voxel_m = 0.05, .max_range_m = 2.0, .stride_px = 1});
  votes.add(wall_frame(), half_door(), along_x());
  EXPECT_EQ(votes.at({1.0F, 0.3F, 1.0F}), SemanticClass::kDoor);  // left of the camera
  EXPECT_EQ(votes.at({1.0F, -0.3F, 1.0F}), SemanticClass::kWall);
  EXPECT_EQ(votes.at({0.5F, 0.3F, 1.0F}), SemanticClass::kUnlabelled);
}

TEST(ClassVotes, TheMajorityOfFramesWins) {
  ClassVotes votes(VoteParams{.voxel_m = 0.05, .max_range_m = 2.0, .stride_px = 1});
  votes.add(wall_frame(), half_door(), along_x());
  const std::vector<SemanticClass> wall(40 * 30, SemanticClass::kWall);
  votes.add(wall_frame(), wall, along_x());
  votes.add(wall_frame(), wall, along_x());
  EXPECT_EQ(votes.at({1.0F, 0.3F, 1.0F}), SemanticClass::kWall);
}

TEST(ClassVotes, FarDepthAndUnlabelledPixelsDoNotVote) {
  ClassVotes votes(VoteParams{.max_range_m = 0.9});
  votes.add(wall_frame(), half_door(), along_x());
  EXPECT_EQ(votes.voxels(), 0U);
  ClassVotes unlabelled;
  unlabelled.add(wall_frame(), std::vector<SemanticClass>(40 * 30), along_x());
  EXPECT_EQ(unlabelled.voxels(), 0U);
}

TEST(ClassVotes, EqualVotesGoToTheLowerClass) {
  ClassVotes votes;
  votes.add({0.01F, 0.01F, 0.01F}, SemanticClass::kOtherProp);
  votes.add({0.01F, 0.01F, 0.01F}, SemanticClass::kTable);
  EXPECT_EQ(votes.at({0.01F, 0.01F, 0.01F}), SemanticClass::kTable);
}

TEST(ClassVotes, WhatDoesNotFitIsRefused) {
  ClassVotes votes;
  EXPECT_THROW(votes.add(wall_frame(), std::vector<SemanticClass>(3), along_x()), InputError);
  Transform<Map, Camera> broken = along_x();
  broken.T(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(votes.add(wall_frame(), half_door(), broken), InputError);
  EXPECT_THROW(ClassVotes(VoteParams{.voxel_m = 0.0}), ArgumentError);
  EXPECT_EQ(votes.voxels(), 0U);
  EXPECT_EQ(votes.at({1e9F, 0, 0}), SemanticClass::kUnlabelled);
}

}  // namespace
}  // namespace amiss::semantics
