#include "localize/internal/global_search.hpp"

#include <gtest/gtest.h>

#include "localize/flat.hpp"

namespace amiss::localize::internal {
namespace {

struct Place {
  testing::Flat flat = testing::Flat::furnished();
  FloorGrid grid = flat.grid();
  DistanceField field{grid};
  std::vector<Eigen::Vector2d> places = places_to_stand(grid, field);
};

const Eigen::Vector2d kLaser = testing::laser_mount().T.translation().head<2>();

const Place& place() {
  static const Place p;
  return p;
}

std::vector<Eigen::Vector2d> seen_from(const testing::Flat& flat, const Pose2<World, Base>& truth) {
  RandomStream random(7, "laser");
  return points_of(testing::scan_from(flat, truth, Stamp{}, random), testing::laser_mount(), 240);
}

TEST(GlobalSearch, PlacesAreFreeAndHaveRoomForARobot) {
  ASSERT_GT(place().places.size(), 1000U);
  for (const Eigen::Vector2d& p : place().places) {
    ASSERT_EQ(place().grid.at(p), Occupancy::kFree);
    ASSERT_GE(place().field.at(p).distance_m, 0.2);
  }
}

TEST(GlobalSearch, FindsThePoseInAFurnishedFlatWithThingsThatAreNotInTheMap) {
  const auto tour = testing::tour();
  RandomStream random(3, "poses");
  for (std::size_t leg = 1; leg < tour.size(); ++leg) {
    const Eigen::Vector2d at = tour[leg - 1] + random.uniform() * (tour[leg] - tour[leg - 1]);
    const Pose2<World, Base> truth{at.x(), at.y(), random.uniform(-3.1, 3.1)};
    testing::Flat today = place().flat;
    today.box({at.x() + 0.9, at.y() + 0.2}, {at.x() + 1.0, at.y() + 0.3});
    const auto points = seen_from(today, truth);
    const auto found = best_on_map(place().field, place().places, points, kLaser, 0.15);
    ASSERT_FALSE(found.empty());
    const Pose2<Map, Base> there{truth.x_m, truth.y_m, truth.yaw_rad};
    EXPECT_TRUE(is_same_place(found.front().T_map_base, there)) << leg;
    EXPECT_LT((found.front().T_map_base.position() - at).norm(), 0.08) << leg;
    EXPECT_GE(found.front().fit, fit_of(place().field, points, there, 0.15) - 0.05) << leg;
    for (std::size_t i = 1; i < found.size(); ++i) {
      EXPECT_LE(found[i].plausibility, found[i - 1].plausibility);
      EXPECT_FALSE(is_same_place(found[i].T_map_base, found.front().T_map_base));
    }
  }
}

TEST(GlobalSearch, NothingToGoByGivesNothing) {
  EXPECT_TRUE(best_on_map(place().field, place().places, {}, kLaser, 0.15).empty());
  EXPECT_TRUE(best_on_map(place().field, {}, {{1.0, 0.0}}, kLaser, 0.15).empty());
}

TEST(GlobalSearch, TheSamePlaceIsNearInPositionAndTurn) {
  EXPECT_TRUE(is_same_place({1.0, 1.0, 3.1}, {1.1, 1.0, -3.1}));
  EXPECT_FALSE(is_same_place({1.0, 1.0, 0.0}, {1.0, 1.0, 1.0}));
  EXPECT_FALSE(is_same_place({1.0, 1.0, 0.0}, {2.0, 1.0, 0.0}));
}

}  // namespace
}  // namespace amiss::localize::internal
