#include "view/view_triangle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

#include "motion/test_flat.hpp"
#include "view/internal/triangle_view.hpp"

namespace amiss::view {
namespace {

/// 0 where the robot's disc fits, infinite elsewhere.
std::vector<float> anywhere_it_fits(const FloorGrid& grid) {
  std::vector<float> travel = distance_to_occupied_m(grid, true);
  for (float& d : travel) d = d >= 0.325F ? 0.0F : std::numeric_limits<float>::infinity();
  return travel;
}

/// Does the segment a-b cross the cell's square, shrunk by `less`?
bool crosses(const FloorGrid& grid, Cell cell, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double less) {
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(grid.resolution_m() * (0.5 - less));
  const Eigen::Vector2d low = grid.centre_of(cell) - half, high = grid.centre_of(cell) + half;
  double begin = 0.0, end = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double d = b[axis] - a[axis];
    if (std::abs(d) < 1e-12) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return false;
      continue;
    }
    const double t0 = (low[axis] - a[axis]) / d, t1 = (high[axis] - a[axis]) / d;
    begin = std::max(begin, std::min(t0, t1));
    end = std::min(end, std::max(t0, t1));
  }
  return begin <= end;
}

bool hidden(const FloorGrid& grid, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double less) {
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.at(Cell{x, y}) != Occupancy::kFree && crosses(grid, {x, y}, a, b, less)) return true;
    }
  }
  return false;
}

FloorGrid cluttered(RandomStream& random) {
  FloorGrid grid = empty_room(4.0, 3.0);
  for (std::uint64_t i = random.below(6); i > 0; --i) {
    const double x = random.uniform(0, 4), y = random.uniform(0, 3);
    fill_rect(grid, x, y, x + random.uniform(0.05, 0.8), y + 0.25, Occupancy::kOccupied);
  }
  return grid;
}

RC_GTEST_PROP(TriangleView, SeesWhatStraightLinesReach, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "view");
  const FloorGrid grid = cluttered(random);
  const double x = random.uniform(0.3, 3.7), y = random.uniform(0.3, 2.7);
  const Eigen::Vector2d apex = grid.centre_of(grid.cell_at({x, y}));
  const Pose2<Map, Base> pose{apex.x(), apex.y(), random.uniform(-3.1, 3.1)};
  internal::TriangleView view(grid, radians(58), 2.0);
  const auto& cells = view.from(pose);
  const std::set<std::uint32_t> seen(cells.begin(), cells.end());
  if (grid.at(apex) != Occupancy::kFree) {
    RC_ASSERT(seen.empty());
    return;
  }
  for (int cy = 0; cy < grid.height(); ++cy) {
    for (int cx = 0; cx < grid.width(); ++cx) {
      const Cell cell{cx, cy};
      const Eigen::Vector2d d = Eigen::Rotation2Dd(-pose.yaw_rad) * (grid.centre_of(cell) - apex);
      const double border = d.x() * std::tan(radians(29)) - std::abs(d.y());
      const bool inside = d.x() <= 2.0 && border >= 0.0 && grid.at(cell) == Occupancy::kFree;
      if (std::abs(border) < 1e-5 || std::abs(d.x() - 2.0) < 1e-5) continue;
      const bool is_seen = seen.count(static_cast<std::uint32_t>(grid.index(cell))) > 0;
      if (!inside) {
        RC_ASSERT(!is_seen);
      } else if (is_seen) {
        RC_ASSERT(!hidden(grid, apex, grid.centre_of(cell), 0.06));
      } else {
        RC_ASSERT(hidden(grid, apex, grid.centre_of(cell), -0.06));
      }
    }
  }
}

/// Greedy without laziness: every gain is counted in every round.
std::vector<Pose2<Map, Base>> plain_greedy(const FloorGrid& sight, const std::vector<ViewTriangle>& samples,
                                           const TriangleParams& params, double target_m2) {
  std::vector<char> covered(sight.cells().size(), 0);
  std::vector<Pose2<Map, Base>> chosen;
  const double cell_m2 = sight.resolution_m() * sight.resolution_m();
  double covered_m2 = 0.0;
  while (static_cast<int>(chosen.size()) < params.max_triangles && covered_m2 < params.coverage_goal * target_m2) {
    std::size_t best = 0;
    double best_m2 = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      double gain_m2 = 0.0;
      for (const auto& p : samples[i].floor_m) {
        if (covered[sight.index(sight.cell_at(p.cast<double>()))] == 0) gain_m2 += cell_m2;
      }
      if (gain_m2 > best_m2 + 1e-9) {
        best = i;
        best_m2 = gain_m2;
      }
    }
    if (best_m2 < params.min_gain_m2 - 1e-9 || best_m2 == 0.0) break;
    for (const auto& p : samples[best].floor_m) covered[sight.index(sight.cell_at(p.cast<double>()))] = 1;
    covered_m2 += best_m2;
    chosen.push_back(samples[best].T_map_base);
  }
  return chosen;
}

TEST(TriangleCover, LazyGreedyChoosesWhatPlainGreedyChooses) {
  const FloorGrid sight = test_flat();
  const auto travel = anywhere_it_fits(sight);
  TriangleParams params;
  params.samples = 200;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    RandomStream random(seed, "cover"), again(seed, "cover");
    const TriangleCover cover = cover_with_triangles(sight, travel, {}, params, random);
    std::vector<Cell> places;
    for (int y = 0; y < sight.height(); ++y) {
      for (int x = 0; x < sight.width(); ++x) {
        if (std::isfinite(travel[sight.index({x, y})])) places.push_back({x, y});
      }
    }
    std::vector<ViewTriangle> samples;
    for (int i = 0; i < params.samples; ++i) {
      const Eigen::Vector2d p = sight.centre_of(places[again.below(places.size())]);
      samples.push_back(
          view_triangle(sight, {p.x(), p.y(), again.uniform(-std::numbers::pi, std::numbers::pi)}, params));
    }
    const auto plain = plain_greedy(sight, samples, params, cover.target_m2);
    ASSERT_EQ(cover.triangles.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
      EXPECT_EQ(cover.triangles[i].T_map_base.position(), plain[i].position());
      EXPECT_EQ(cover.triangles[i].T_map_base.yaw_rad, plain[i].yaw_rad);
    }
    EXPECT_LT(cover.evaluations, 20 * params.samples / 4);
  }
}

TEST(TriangleCover, CoversMostOfAFlatWithAboutTwentyAndOfARoomWithAboutTen) {
  const FloorGrid flat = test_flat(), room = empty_room(6.0, 5.0);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    RandomStream random(seed, "cover");
    const TriangleCover large = cover_with_triangles(flat, anywhere_it_fits(flat), {}, {}, random);
    EXPECT_LE(large.triangles.size(), 22U);
    EXPECT_GE(large.triangles.size(), 16U);
    const TriangleCover small = cover_with_triangles(room, anywhere_it_fits(room), {}, {}, random);
    EXPECT_GE(small.triangles.size(), 7U);
    EXPECT_LE(small.triangles.size(), 12U);
  }
}

TEST(TriangleCover, StandsOnlyWhereTheRobotCanBeAndReportsWhatItCovers) {
  const FloorGrid sight = test_flat();
  auto travel = anywhere_it_fits(sight);
  for (int y = 0; y < sight.height(); ++y) {
    for (int x = 0; x < sight.width(); ++x) {
      if (sight.centre_of({x, y}).x() > 5.0) travel[sight.index({x, y})] = std::numeric_limits<float>::infinity();
    }
  }
  RandomStream random(1, "cover");
  const TriangleCover cover = cover_with_triangles(sight, travel, {}, {}, random);
  std::set<std::pair<int, int>> seen;
  for (const ViewTriangle& triangle : cover.triangles) {
    EXPECT_LT(triangle.T_map_base.x_m, 5.0);
    EXPECT_TRUE(std::isfinite(travel[sight.index(sight.cell_at(triangle.T_map_base.position()))]));
    for (const auto& p : triangle.floor_m) {
      const Cell c = sight.cell_at(p.cast<double>());
      EXPECT_EQ(sight.at(c), Occupancy::kFree);
      seen.insert({c.x, c.y});
    }
  }
  EXPECT_NEAR(cover.coverage * cover.target_m2, static_cast<double>(seen.size()) * 0.0025, 1e-6);
}

TEST(TriangleCover, LeavesOutWhatIsCoveredAlready) {
  const FloorGrid sight = empty_room(6.0, 5.0);
  const auto travel = anywhere_it_fits(sight);
  FloorGrid covered(0.1, {0.0, 0.0}, 60, 50);
  fill_rect(covered, 0.0, 0.0, 3.0, 5.0, Occupancy::kFree);
  RandomStream random(1, "cover");
  const TriangleCover half = cover_with_triangles(sight, travel, covered, {}, random);
  EXPECT_GE(half.coverage, 0.75);
  for (const ViewTriangle& triangle : half.triangles) EXPECT_LT(covered_fraction(triangle, covered), 0.9);
  fill_rect(covered, -1.0, -1.0, 7.0, 7.0, Occupancy::kFree);
  const TriangleCover none = cover_with_triangles(sight, travel, covered, {}, random);
  EXPECT_TRUE(none.triangles.empty());
  EXPECT_EQ(none.coverage, 1.0);
}

TEST(TriangleCover, RoundsEndWhenNothingIsWorthALook) {
  const FloorGrid sight = test_flat();
  const auto travel = anywhere_it_fits(sight);
  FloorGrid covered(sight.resolution_m(), sight.origin_m(), sight.width(), sight.height());
  RandomStream random(1, "rounds");
  double coverage = 0.0;
  std::size_t triangles = 0;
  for (int round = 0; round < 20; ++round) {
    const TriangleCover cover = cover_with_triangles(sight, travel, covered, {}, random);
    EXPECT_GE(cover.coverage, coverage);
    coverage = cover.coverage;
    triangles += cover.triangles.size();
    if (cover.triangles.empty()) break;
    for (const ViewTriangle& triangle : cover.triangles) {
      for (const auto& p : triangle.floor_m) covered.set(covered.cell_at(p.cast<double>()), Occupancy::kFree);
    }
  }
  EXPECT_GE(coverage, 0.95);
  EXPECT_LE(triangles, 90U);
}

TEST(TriangleCover, HasNothingToSayWhereTheRobotCannotBe) {
  const FloorGrid sight = empty_room(2.0, 2.0);
  const std::vector<float> nowhere(sight.cells().size(), std::numeric_limits<float>::infinity());
  RandomStream random(1, "cover");
  EXPECT_TRUE(cover_with_triangles(sight, nowhere, {}, {}, random).triangles.empty());
}

TEST(CoveredFraction, CountsKnownFloor) {
  const FloorGrid sight = empty_room(6.0, 5.0);
  const ViewTriangle triangle = view_triangle(sight, {1.025, 2.525, 0.0}, {});
  EXPECT_NEAR(static_cast<double>(triangle.floor_m.size()) * 0.0025, 4.0 * std::tan(radians(29)), 0.06);
  FloorGrid seen(0.05, sight.origin_m(), sight.width(), sight.height());
  EXPECT_EQ(covered_fraction(triangle, seen), 0.0);
  fill_rect(seen, 0.0, 0.0, 6.0, 2.5, Occupancy::kFree);
  EXPECT_NEAR(covered_fraction(triangle, seen), 0.5, 0.03);
  fill_rect(seen, 0.0, 2.5, 6.0, 5.0, Occupancy::kOccupied);
  EXPECT_EQ(covered_fraction(triangle, seen), 1.0);
}

}  // namespace
}  // namespace amiss::view
