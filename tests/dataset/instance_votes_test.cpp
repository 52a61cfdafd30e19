#include "dataset/instance_votes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/result.hpp"

namespace amiss::dataset {
namespace {

/// A camera at the origin of the map that looks along its z at a wall at 1 m: the left half is body 3, the right 8.
PosedFrame wall(double z_m = 1.0) {
  PosedFrame posed;
  posed.frame.intrinsics = {40, 30, 40.0, 40.0, 19.5, 14.5};
  posed.frame.depth_m.assign(1200, static_cast<float>(z_m));
  return posed;
}
std::vector<std::uint16_t> halves() {
  std::vector<std::uint16_t> numbers(1200);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i % 40 < 20 ? 3 : 8;
  return numbers;
}

TEST(InstanceVotes, APointIsWhatTheFrameShowsWhereItIs) {
  InstanceVotes votes({{-0.2F, 0.0F, 1.0F},    // on the left half
                       {0.2F, 0.1F, 1.01F},    // on the right one, a little behind
                       {0.2F, 0.0F, 1.2F},     // behind the wall
                       {0.0F, 0.0F, -1.0F},    // behind the camera
                       {3.0F, 0.0F, 1.0F}});   // beside the image
  votes.add(wall(), halves());
  EXPECT_EQ(votes.numbers(), (std::vector<std::uint16_t>{3, 8, 0, 0, 0}));
}

TEST(InstanceVotes, TheMostVotesWinAndOfEqualsTheSmallerNumber) {
  InstanceVotes votes({{-0.2F, 0.0F, 1.0F}});
  const std::vector<std::uint16_t> eight(1200, 8), two(1200, 2);
  votes.add(wall(), eight);
  votes.add(wall(), two);
  EXPECT_EQ(votes.numbers()[0], 2);
  votes.add(wall(), eight);
  EXPECT_EQ(votes.numbers()[0], 8);
  for (std::uint16_t number = 20; number < 24; ++number) votes.add(wall(), std::vector<std::uint16_t>(1200, number));
  EXPECT_EQ(votes.numbers()[0], 8);
}

TEST(InstanceVotes, PosesMovePointsAndHolesDoNotVote) {
  PosedFrame moved = wall();
  moved.T_map_camera.T.translation() = Eigen::Vector3d(5.0, 0.0, 0.0);
  InstanceVotes votes({{4.8F, 0.0F, 1.0F}});
  PosedFrame holes = moved;
  holes.frame.depth_m.assign(1200, std::numeric_limits<float>::quiet_NaN());
  votes.add(holes, halves());
  EXPECT_EQ(votes.numbers()[0], 0);
  votes.add(moved, halves());
  EXPECT_EQ(votes.numbers()[0], 3);
  EXPECT_THROW(votes.add(moved, std::vector<std::uint16_t>(3)), ArgumentError);
}

}  // namespace
}  // namespace amiss::dataset
