#include "core/line_cells.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "core/random.hpp"

namespace amiss {
namespace {

struct Step {
  Cell cell;
  double begin = 0.0, end = 0.0;
};

std::vector<Step> steps(const FloorGrid& grid, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  std::vector<Step> visited;
  EXPECT_TRUE(for_line_cells(grid, a, b, [&](Cell cell, double begin, double end) {
    visited.push_back({cell, begin, end});
    return true;
  }));
  return visited;
}

const FloorGrid kGrid(0.05, {-1.0, -2.0}, 60, 80, Occupancy::kFree);

RC_GTEST_PROP(LineCells, AreTheCellsOfThePartsOfTheLine, (unsigned seed)) {
  RandomStream random(seed, "line");
  const Eigen::Vector2d a(random.uniform(-0.9, 1.9), random.uniform(-1.9, 1.9));
  const Eigen::Vector2d b(random.uniform(-0.9, 1.9), random.uniform(-1.9, 1.9));
  const auto visited = steps(kGrid, a, b);
  RC_ASSERT(visited.front().begin == 0.0);
  RC_ASSERT(visited.back().end == 1.0);
  for (std::size_t i = 0; i < visited.size(); ++i) {
    const Step& step = visited[i];
    if (i > 0) RC_ASSERT(step.begin == visited[i - 1].end);
    const Eigen::Vector2d middle = a + 0.5 * (step.begin + step.end) * (b - a);
    const Eigen::Vector2d offset = middle - kGrid.centre_of(step.cell);
    RC_ASSERT(offset.cwiseAbs().maxCoeff() <= 0.025 + 1e-9);
  }
}

TEST(LineCells, EndWhenTheVisitorSaysSo) {
  int visits = 0;
  EXPECT_FALSE(for_line_cells(kGrid, {0.0, 0.0}, {1.0, 0.0}, [&](Cell, double, double) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

TEST(LineCells, PointIsOneCell) {
  const auto visited = steps(kGrid, {0.01, 0.01}, {0.01, 0.01});
  ASSERT_EQ(visited.size(), 1U);
  EXPECT_EQ(visited[0].cell, kGrid.cell_at({0.01, 0.01}));
}

TEST(LineCells, AlongAnAxisNoCellIsLeftOut) {
  const auto up = steps(kGrid, {0.51, -1.51}, {0.51, 1.51});
  const auto down = steps(kGrid, {0.51, 1.51}, {0.51, -1.51});
  ASSERT_EQ(up.size(), 62U);
  ASSERT_EQ(down.size(), 62U);
  for (std::size_t i = 0; i < up.size(); ++i) EXPECT_EQ(up[i].cell, down[up.size() - 1 - i].cell);
}

}  // namespace
}  // namespace amiss
