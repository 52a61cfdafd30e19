#include "motion/path_lengths.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <queue>

#include "core/random.hpp"
#include "motion/path.hpp"
#include "motion/test_flat.hpp"

namespace amiss::motion {
namespace {

/// Dijkstra as in the book: a heap, every pair of cells within two steps, the straight line between them passable.
std::vector<double> slow_lengths(const DriveMap& map, Cell start) {
  const FloorGrid& grid = map.grid();
  std::vector<double> length(grid.cells().size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  length[grid.index(start)] = 0.0;
  open.push({0.0, grid.index(start)});
  const auto width = static_cast<std::size_t>(grid.width());
  while (!open.empty()) {
    const auto [d, at] = open.top();
    open.pop();
    if (d > length[at]) continue;
    const Cell c{static_cast<int>(at % width), static_cast<int>(at / width)};
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        if (std::abs(dx) + std::abs(dy) > 3 ||
            std::max(std::abs(dx), std::abs(dy)) * 2 == std::abs(dx) + std::abs(dy) + 2)
          continue;
        const Cell next{c.x + dx, c.y + dy};
        if (!grid.contains(next) || !map.passable(next)) continue;
        if (std::abs(dx) == 1 && std::abs(dy) == 1 && (!map.passable({next.x, c.y}) || !map.passable({c.x, next.y})))
          continue;
        if (!straight_passable(map, grid.centre_of(c), grid.centre_of(next))) continue;
        const double longer = d + std::hypot(dx, dy) * grid.resolution_m();
        if (longer < length[grid.index(next)]) {
          length[grid.index(next)] = longer;
          open.push({longer, grid.index(next)});
        }
      }
    }
  }
  return length;
}

DriveMap cluttered(RandomStream& random) {
  FloorGrid grid = empty_room(4.0, 3.0);
  for (std::uint64_t i = random.below(5); i > 0; --i) {
    const double x = random.uniform(0, 4), y = random.uniform(0, 3);
    fill_rect(grid, x, y, x + random.uniform(0.05, 1.0), y + 0.3, Occupancy::kOccupied);
  }
  return {grid, {}};
}

RC_GTEST_PROP(PathLengths, EqualASlowDijkstra, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "lengths");
  const DriveMap map = cluttered(random);
  const double x = random.uniform(0, 4);
  const Eigen::Vector2d from(x, random.uniform(0, 3));
  const PathLengths lengths(map, from, 0.0);
  const Cell start = map.grid().cell_at(from);
  if (!map.passable(start)) {
    RC_ASSERT(lengths.to(from) == PathLengths::kUnreachable);
    return;
  }
  const auto slow = slow_lengths(map, start);
  for (std::size_t i = 0; i < slow.size(); ++i) {
    const auto fast = static_cast<double>(lengths.field()[i]);
    RC_ASSERT(std::isfinite(fast) == std::isfinite(slow[i]));
    if (std::isfinite(fast)) RC_ASSERT(std::abs(fast - slow[i]) < 1e-4);
  }
}

TEST(PathLengths, AreAtMostThreePercentLongerThanStraightLines) {
  const DriveMap map(empty_room(8.0, 8.0), {});
  const PathLengths lengths(map, {0.525, 0.525});
  for (double angle = 0.02; angle < 1.55; angle += 0.1) {
    const Eigen::Vector2d to = map.grid().centre_of(
        map.grid().cell_at(Eigen::Vector2d(0.525 + 6.5 * std::cos(angle), 0.525 + 6.5 * std::sin(angle))));
    const double straight = (to - Eigen::Vector2d(0.525, 0.525)).norm();
    EXPECT_GE(static_cast<double>(lengths.to(to)), straight - 1e-4);
    EXPECT_LE(static_cast<double>(lengths.to(to)), 1.028 * straight);
  }
}

TEST(PathLengths, GoThroughDoorsAndNotThroughWalls) {
  const DriveMap map(test_flat(), {});
  const PathLengths lengths(map, {4.0, 3.75});
  EXPECT_LT(lengths.to(Eigen::Vector2d(9.0, 6.0)), 12.0F);
  EXPECT_GT(lengths.to(Eigen::Vector2d(9.0, 6.0)), 6.0F);
  EXPECT_EQ(lengths.to(Eigen::Vector2d(0.5, 2.0)), PathLengths::kUnreachable);  // in the sofa
  EXPECT_EQ(lengths.to(Eigen::Vector2d(50.0, 2.0)), PathLengths::kUnreachable);
  EXPECT_LT(lengths.near({0.75, 2.0}, 0.6), PathLengths::kUnreachable);
  const auto way = lengths.way_to({9.0, 6.0});
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    EXPECT_TRUE(straight_passable(map, way[i - 1], way[i]));
    length += (way[i] - way[i - 1]).norm();
  }
  EXPECT_NEAR(length, static_cast<double>(lengths.to(Eigen::Vector2d(9.0, 6.0))), 1e-3);
  EXPECT_TRUE(lengths.way_to({0.5, 2.0}).empty());
}

TEST(PathLengths, BeginNearAPlaceThatIsTooNarrow) {
  const DriveMap map(empty_room(4.0, 4.0), {});
  EXPECT_NEAR(static_cast<double>(PathLengths(map, {0.125, 2.025}).to(Eigen::Vector2d(2.025, 2.025))), 1.9, 0.03);
  EXPECT_EQ(PathLengths(map, {0.125, 2.025}, 0.1).to(Eigen::Vector2d(2.025, 2.025)), PathLengths::kUnreachable);
}

TEST(WayMatrix, IsSymmetricAndKnowsWhatIsOutOfReach) {
  const DriveMap map(test_flat(), {});
  const std::vector<Eigen::Vector2d> places{{4.0, 3.75}, {9.0, 6.0}, {6.5, 1.5}, {50.0, 50.0}};
  const auto matrix = way_matrix(map, places);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(matrix[i * 4 + i], 0.0);
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_EQ(matrix[i * 4 + j], matrix[j * 4 + i]);
      EXPECT_EQ(std::isfinite(matrix[i * 4 + j]), i == j || (i != 3 && j != 3));
    }
  }
}

TEST(WayMatrix, PlacesBesideAPocketThatNobodyCanGetIntoStayInReach) {
  FloorGrid grid = empty_room(7.0, 4.0);
  fill_rect(grid, 3.0, 0.0, 5.0, 2.0, Occupancy::kOccupied);
  fill_rect(grid, 3.1, 0.0, 4.9, 1.9, Occupancy::kFree);
  const DriveMap map(grid, {});
  const Eigen::Vector2d beside_pocket(3.1, 1.0);
  const auto nearest = map.nearest_passable(beside_pocket, 0.5);
  ASSERT_TRUE(nearest.has_value());
  ASSERT_GT(grid.centre_of(*nearest).x(), 3.1) << "inside the pocket";
  const auto matrix = way_matrix(map, std::vector<Eigen::Vector2d>{{1.0, 1.0}, beside_pocket, {6.0, 3.0}});
  for (const double length : matrix) EXPECT_TRUE(std::isfinite(length));
  EXPECT_GT(matrix[1 * 3 + 2], 3.0);
  EXPECT_LT(matrix[1 * 3 + 2], matrix[1] + matrix[2]);
}

}  // namespace
}  // namespace amiss::motion
