#include "core/random.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace amiss {
namespace {

// From a second implementation, which gives the published first values of xoshiro256** for the state {1, 2, 3, 4}.
TEST(Random, KnownValues) {
  RandomStream laser(1, "laser");
  for (const std::uint64_t value :
       {0xafd1bbccf04c0780ULL, 0x2e72031ed550a233ULL, 0x3595a3265740cee2ULL, 0x2ad51211d81fd8e4ULL}) {
    EXPECT_EQ(laser.next(), value);
  }
  RandomStream nameless(42, "");
  for (const std::uint64_t value : {0x4b754824dc9b9a86ULL, 0xf3909741e47d08e3ULL, 0x3ec19ab6530b56f9ULL}) {
    EXPECT_EQ(nameless(), value);
  }
}

TEST(Random, SeedAndNameTellStreamsApart) {
  std::set<std::uint64_t> firsts;
  int streams = 0;
  for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 1ULL << 63U}) {
    for (const char* name : {"", "laser", "odometry", "scatter", "scattes"}) {
      firsts.insert(RandomStream(seed, name).next());
      ++streams;
    }
  }
  EXPECT_EQ(firsts.size(), static_cast<std::size_t>(streams));
}

/// Correlation of two streams of uniform numbers.
double correlation(RandomStream a, RandomStream b, int n) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += (a.uniform() - 0.5) * (b.uniform() - 0.5);
  return 12.0 * sum / n;
}

TEST(Random, StreamsAreIndependent) {
  constexpr int kDraws = 100000;
  const double limit = 5.0 / std::sqrt(kDraws);
  EXPECT_LT(std::abs(correlation({1, "laser"}, {1, "odometry"}, kDraws)), limit);
  EXPECT_LT(std::abs(correlation({1, "laser"}, {2, "laser"}, kDraws)), limit);
  RandomStream parent(1, "laser");
  EXPECT_LT(std::abs(correlation(parent.child("a"), parent.child("b"), kDraws)), limit);
  EXPECT_GT(correlation({1, "laser"}, {1, "laser"}, kDraws), 0.99) << "the same stream again";
}

TEST(Random, ChildrenOfEqualParentsAreEqual) {
  RandomStream a(9, "x"), b(9, "x");
  EXPECT_EQ(a.child("frame").next(), b.child("frame").next());
  EXPECT_EQ(a.next(), b.next());
}

/// Chi-squared of counts that should be equal.
template <std::size_t n>
double chi_squared(const std::array<int, n>& counts, double expected) {
  double sum = 0.0;
  for (const int c : counts) sum += (c - expected) * (c - expected) / expected;
  return sum;
}

TEST(Random, UniformIsUniform) {
  RandomStream random(7, "uniform");
  std::array<int, 100> counts{};
  for (int i = 0; i < 100000; ++i) {
    const double u = random.uniform();
    ASSERT_TRUE(u >= 0.0 && u < 1.0);
    ++counts[static_cast<std::size_t>(100.0 * u)];
  }
  EXPECT_LT(chi_squared(counts, 1000.0), 99.0 + 5.0 * std::sqrt(2.0 * 99.0));
}

TEST(Random, BelowIsUniformAndReachesBothEnds) {
  RandomStream random(7, "below");
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts[random.below(7)];
  EXPECT_LT(chi_squared(counts, 10000.0), 6.0 + 5.0 * std::sqrt(12.0));
  for (int i = 0; i < 10; ++i) EXPECT_EQ(random.below(1), 0U);
}

RC_GTEST_PROP(Random, BelowStaysBelow, (std::uint64_t seed)) {
  RandomStream random(seed, "below");
  const std::uint64_t limit = *rc::gen::arbitrary<std::uint64_t>();
  for (int i = 0; i < 20; ++i) RC_ASSERT(random.below(limit | 1U) < (limit | 1U));
}

RC_GTEST_PROP(Random, UniformStaysInItsRange, (std::uint64_t seed)) {
  RandomStream random(seed, "range");
  const double low = *rc::gen::inRange(-1000, 1000), width = *rc::gen::inRange(1, 1000);
  for (int i = 0; i < 20; ++i) {
    const double u = random.uniform(low, low + width);
    RC_ASSERT(u >= low && u < low + width);
  }
}

TEST(Random, NormalHasTheMomentsOfOne) {
  RandomStream random(7, "normal");
  constexpr int kDraws = 200000;
  double sum = 0.0, squares = 0.0, fourth = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double z = random.normal();
    sum += z;
    squares += z * z;
    fourth += z * z * z * z;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.012);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.02);
  EXPECT_NEAR(fourth / kDraws, 3.0, 0.15);
}

TEST(Random, ServesTheStandardLibrary) {
  RandomStream random(5, "shuffle");
  std::vector<int> values(50);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<int>(i);
  std::shuffle(values.begin(), values.end(), random);
  EXPECT_FALSE(std::is_sorted(values.begin(), values.end()));
  std::sort(values.begin(), values.end());
  EXPECT_EQ(values.front(), 0);
  EXPECT_EQ(values.back(), 49);
}

}  // namespace
}  // namespace amiss
