#include "core/floor_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "core/random.hpp"

namespace amiss {
namespace {

FloorGrid random_grid(RandomStream& random, int width, int height, double occupied, double unknown) {
  FloorGrid grid(0.05, {-1.3, 0.7}, width, height, Occupancy::kFree);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = random.uniform();
      if (u < occupied) grid.set({x, y}, Occupancy::kOccupied);
      if (u > 1.0 - unknown) grid.set({x, y}, Occupancy::kUnknown);
    }
  }
  return grid;
}

/// Every cell against every other one.
std::vector<float> slow_distance(const FloorGrid& grid, bool unknown_is_occupied) {
  std::vector<float> distance;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      double nearest = std::numeric_limits<double>::infinity();
      for (int v = 0; v < grid.height(); ++v) {
        for (int u = 0; u < grid.width(); ++u) {
          const Occupancy value = grid.at(Cell{u, v});
          if (value == Occupancy::kFree || (value == Occupancy::kUnknown && !unknown_is_occupied)) continue;
          nearest = std::min(nearest, std::hypot(u - x, v - y) * grid.resolution_m());
        }
      }
      distance.push_back(static_cast<float>(nearest));
    }
  }
  return distance;
}

/// Does the segment a-b (in cells) cross the square of the cell, grown by `margin` on each side?
bool crosses(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Cell c, double margin) {
  double enter = 0.0, leave = 1.0;
  const Eigen::Vector2d low(c.x - margin, c.y - margin), high(c.x + 1.0 + margin, c.y + 1.0 + margin);
  for (int i = 0; i < 2; ++i) {
    const double step = b[i] - a[i];
    if (step == 0.0) {
      if (a[i] < low[i] || a[i] > high[i]) return false;
      continue;
    }
    const double t0 = (low[i] - a[i]) / step, t1 = (high[i] - a[i]) / step;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave;
}

/// Is every cell free that the segment crosses?
bool slow_sight(const FloorGrid& grid, const Eigen::Vector2d& a_map, const Eigen::Vector2d& b_map, double margin) {
  const Eigen::Vector2d a = (a_map - grid.origin_m()) / grid.resolution_m();
  const Eigen::Vector2d b = (b_map - grid.origin_m()) / grid.resolution_m();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.at(Cell{x, y}) != Occupancy::kFree && crosses(a, b, {x, y}, margin)) return false;
    }
  }
  return true;
}

TEST(FloorGrid, CellsAndCentres) {
  const FloorGrid grid(0.05, {-1.0, 2.0}, 40, 20);
  EXPECT_EQ(grid.cell_at({-1.0 + 1e-9, 2.0 + 1e-9}), (Cell{0, 0}));
  EXPECT_EQ(grid.cell_at({-1.001, 2.001}), (Cell{-1, 0}));
  for (const Cell c : {Cell{0, 0}, Cell{39, 19}, Cell{7, 11}}) EXPECT_EQ(grid.cell_at(grid.centre_of(c)), c);
  EXPECT_TRUE(grid.contains({39, 19}));
  EXPECT_FALSE(grid.contains({40, 19}));
  EXPECT_EQ(grid.at(Cell{-1, 5}), Occupancy::kUnknown) << "outside is unknown";
}

TEST(FloorGrid, EmptyGridHasNoDistances) {
  EXPECT_TRUE(distance_to_occupied_m(FloorGrid(), true).empty());
  EXPECT_EQ(FloorGrid().at(Eigen::Vector2d(0.0, 0.0)), Occupancy::kUnknown);
}

TEST(FloorGrid, DilatedGrowsSquaresAndStaysInside) {
  RandomStream random(3, "dilated");
  for (int radius = 0; radius <= 3; ++radius) {
    const FloorGrid grid = random_grid(random, 23, 17, 0.05, 0.2);
    const FloorGrid grown = dilated(grid, radius);
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        bool near = false;
        for (int v = y - radius; v <= y + radius; ++v) {
          for (int u = x - radius; u <= x + radius; ++u) near = near || grid.at(Cell{u, v}) == Occupancy::kOccupied;
        }
        EXPECT_EQ(grown.at(Cell{x, y}), near ? Occupancy::kOccupied : grid.at(Cell{x, y}));
      }
    }
  }
}

TEST(FloorGrid, DistanceIsThatOfTheSlowWay) {
  RandomStream random(1, "distance");
  for (int round = 0; round < 40; ++round) {
    const int width = 1 + static_cast<int>(random.below(40)), height = 1 + static_cast<int>(random.below(40));
    const FloorGrid grid = random_grid(random, width, height, round % 2 == 0 ? 0.02 : 0.3, 0.05);
    for (const bool unknown_is_occupied : {false, true}) {
      const auto fast = distance_to_occupied_m(grid, unknown_is_occupied);
      const auto slow = slow_distance(grid, unknown_is_occupied);
      ASSERT_EQ(fast.size(), slow.size());
      for (std::size_t i = 0; i < fast.size(); ++i) {
        if (std::isinf(slow[i])) {
          EXPECT_GT(fast[i], 1000.0F) << "nothing is occupied: far";
        } else {
          EXPECT_NEAR(fast[i], slow[i], 1e-5F);
        }
      }
    }
  }
}

TEST(FloorGrid, SightIsThatOfTheSlowWay) {
  RandomStream random(2, "sight");
  int seen = 0;
  for (int round = 0; round < 4000; ++round) {
    const FloorGrid grid = random_grid(random, 24, 18, 0.03, 0.02);
    const auto point = [&] { return Eigen::Vector2d(random.uniform(-1.4, 0.0), random.uniform(0.65, 1.65)); };
    const Eigen::Vector2d a = point(), b = point();
    const bool inside = grid.contains(grid.cell_at(a)) && grid.contains(grid.cell_at(b));
    const bool sight = line_of_sight(grid, a, b);
    seen += sight ? 1 : 0;
    if (sight) {
      EXPECT_TRUE(inside && slow_sight(grid, a, b, -1e-9));
    } else if (inside) {
      EXPECT_FALSE(slow_sight(grid, a, b, 1e-9));
    }
  }
  EXPECT_GT(seen, 500);
}

TEST(FloorGrid, SightAlongAxesAndOfOnePlace) {
  FloorGrid grid(0.1, {0.0, 0.0}, 10, 10, Occupancy::kFree);
  grid.set({5, 5}, Occupancy::kOccupied);
  EXPECT_FALSE(line_of_sight(grid, {0.05, 0.55}, {0.95, 0.55}));
  EXPECT_FALSE(line_of_sight(grid, {0.55, 0.95}, {0.55, 0.05}));
  EXPECT_TRUE(line_of_sight(grid, {0.05, 0.45}, {0.95, 0.45}));
  EXPECT_TRUE(line_of_sight(grid, {0.35, 0.95}, {0.35, 0.05}));
  EXPECT_TRUE(line_of_sight(grid, {0.35, 0.35}, {0.35, 0.35}));
  EXPECT_FALSE(line_of_sight(grid, {0.55, 0.55}, {0.55, 0.55}));
  EXPECT_FALSE(line_of_sight(grid, {0.35, 0.35}, {1.35, 0.35})) << "outside is unknown";
}

}  // namespace
}  // namespace amiss
