#include "motion/tour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/frames.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace amiss::motion {
namespace {

std::vector<double> random_matrix(std::size_t n, RandomStream& random) {
  std::vector<Eigen::Vector2d> places(n);
  for (auto& p : places) {
    const double x = random.uniform(0, 12);
    p = {x, random.uniform(0, 8)};
  }
  std::vector<double> lengths(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) lengths[i * n + j] = (places[i] - places[j]).norm();
  }
  return lengths;
}

double length_of(const std::vector<double>& lengths, std::size_t n, const std::vector<std::size_t>& order) {
  double sum = 0.0;
  std::size_t at = 0;
  for (const std::size_t next : order) {
    sum += lengths[at * n + next];
    at = next;
  }
  return sum;
}

double brute_force(const std::vector<double>& lengths, std::size_t n) {
  std::vector<std::size_t> order(n - 1);
  std::iota(order.begin(), order.end(), std::size_t{1});
  double best = std::numeric_limits<double>::infinity();
  do {
    best = std::min(best, length_of(lengths, n, order));
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(Tour, IsOptimalForNearlyAllSmallProblemsAndNearlySoForAll) {
  RandomStream random(1, "tour");
  int optimal = 0;
  constexpr int kProblems = 200;
  for (int i = 0; i < kProblems; ++i) {
    const std::size_t n = 3 + random.below(6);
    const auto lengths = random_matrix(n, random);
    const Tour tour = shortest_tour(lengths, n);
    const double best = brute_force(lengths, n);
    EXPECT_LE(tour.length_m, 1.05 * best);
    optimal += tour.length_m <= best * (1 + 1e-9) ? 1 : 0;
  }
  EXPECT_GT(optimal, kProblems * 9 / 10);
}

TEST(Tour, VisitsEachPlaceOnceAndTellsItsLength) {
  RandomStream random(2, "tour");
  for (const std::size_t n : {1UL, 2UL, 12UL, 30UL}) {
    const auto lengths = random_matrix(n, random);
    const Tour tour = shortest_tour(lengths, n);
    std::vector<std::size_t> sorted = tour.order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::size_t> expected(n - 1);
    std::iota(expected.begin(), expected.end(), std::size_t{1});
    EXPECT_EQ(sorted, expected);
    EXPECT_NEAR(tour.length_m, length_of(lengths, n, tour.order), 1e-9);
    EXPECT_EQ(tour.reachable, n - 1);
  }
}

TEST(Tour, PutsUnreachablePlacesLast) {
  const double none = std::numeric_limits<double>::infinity();
  const std::vector<double> lengths{0, none, 2, none, 0, none, 2, none, 0};
  const Tour tour = shortest_tour(lengths, 3);
  EXPECT_EQ(tour.order, (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(tour.reachable, 1U);
  EXPECT_DOUBLE_EQ(tour.length_m, 2.0);
}

TEST(Tour, HoldsEachPlaceEvenWhenNoOrderHasAWay) {
  const double none = std::numeric_limits<double>::infinity();
  const std::vector<double> lengths{0, 1, 2, 1, 0, none, 2, none, 0};  // both from the start, none between them
  Tour tour = shortest_tour(lengths, 3);
  std::sort(tour.order.begin(), tour.order.end());
  EXPECT_EQ(tour.order, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(tour.reachable, 2U);
  EXPECT_EQ(tour.length_m, none);
}

TEST(Tour, RefusesMatricesThatAreNotSquare) {
  EXPECT_THROW((void)shortest_tour(std::vector<double>(5), 2), ArgumentError);
  EXPECT_THROW((void)shortest_tour({}, 0), ArgumentError);
}

}  // namespace
}  // namespace amiss::motion
