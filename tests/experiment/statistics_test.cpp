#include "experiment/statistics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace amiss::experiment {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(Quantile, IsLinearBetweenOrderStatistics) {
  const Quartiles q = quartiles({4, 1, 3, 2});  // quantile(c(1,2,3,4)) of R: 1.75 2.50 3.25
  EXPECT_DOUBLE_EQ(q.q1, 1.75);
  EXPECT_DOUBLE_EQ(q.median, 2.5);
  EXPECT_DOUBLE_EQ(q.q3, 3.25);
  EXPECT_DOUBLE_EQ(quantile({7}, 0.3), 7.0);
  EXPECT_DOUBLE_EQ(quantile({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 0.1), 1.9);
  EXPECT_DOUBLE_EQ(quantile({1, 5}, 1.0), 5.0);
}

TEST(Quantile, InfinityIsLongerThanAll) {
  EXPECT_DOUBLE_EQ(quantile({1, 2, kInfinite}, 0.5), 2.0);
  EXPECT_EQ(quantile({1, kInfinite}, 0.5), kInfinite);
  EXPECT_EQ(quantile({kInfinite, kInfinite}, 0.5), kInfinite);
  EXPECT_DOUBLE_EQ(quantile({-kInfinite, kInfinite}, 0.5), 0.0);
}

/// All n^n samples with replacement, each once.
Interval exhaustive(const std::vector<double>& values) {
  const std::size_t n = values.size();
  std::vector<double> medians;
  std::vector<std::size_t> digits(n, 0);
  for (bool more = true; more;) {
    std::vector<double> sample;
    for (const std::size_t d : digits) sample.push_back(values[d]);
    medians.push_back(quantile(sample, 0.5));
    more = false;
    for (std::size_t& d : digits) {
      if (++d < n) {
        more = true;
        break;
      }
      d = 0;
    }
  }
  return {quantile(medians, 0.025), quantile(medians, 0.975)};
}

TEST(Bootstrap, AgreesWithAllSamples) {
  for (const std::vector<double>& values :
       {std::vector<double>{3, 8, 1}, {2, 7, 1, 8, 2.5}, {5, 5, 5, 9, 1}, {1, 2, 3, 4, kInfinite}, {4}}) {
    RandomStream random(1, "bootstrap");
    const Interval drawn = bootstrap_median(values, random, 20000), all = exhaustive(values);
    EXPECT_DOUBLE_EQ(drawn.low, all.low);
    EXPECT_DOUBLE_EQ(drawn.high, all.high);
  }
}

TEST(Bootstrap, HoldsTheMedianAsOftenAsItSays) {
  RandomStream random(2, "coverage");
  int held = 0;
  constexpr int kSamples = 400;
  for (int i = 0; i < kSamples; ++i) {
    std::vector<double> values;
    for (int k = 0; k < 25; ++k) values.push_back(random.normal());
    const Interval interval = bootstrap_median(values, random, 300);
    held += interval.low <= 0.0 && 0.0 <= interval.high ? 1 : 0;
  }
  EXPECT_GT(held, kSamples * 90 / 100);
  EXPECT_LT(held, kSamples * 99 / 100);
}

TEST(Wilcoxon, OfTheDepressionScales) {
  // Hollander and Wolfe (1973), p. 29f.; R: wilcox.test(x, y, paired = TRUE) gives V = 40, p-value = 0.03906.
  const std::vector<double> x{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const std::vector<double> y{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> differences;
  for (std::size_t i = 0; i < x.size(); ++i) differences.push_back(x[i] - y[i]);
  const SignedRank result = wilcoxon(differences);
  EXPECT_EQ(result.n, 9);
  EXPECT_DOUBLE_EQ(result.w_plus, 40.0);
  EXPECT_DOUBLE_EQ(result.w_minus, 5.0);
  EXPECT_NEAR(result.p, 0.0390625, 1e-12);
  EXPECT_TRUE(result.exact);
  EXPECT_NEAR(result.effect, 35.0 / 45.0, 1e-12);
}

TEST(Wilcoxon, OfDarwinsMaize) {
  // Heights of crossed and self-fertilized plants, eighths of an inch; exact p as SciPy's manual gives it.
  const SignedRank result = wilcoxon({6, 8, 14, 16, 23, 24, 28, 29, 41, -48, 49, 56, 60, -67, 75});
  EXPECT_DOUBLE_EQ(result.w_minus, 24.0);
  EXPECT_NEAR(result.p, 0.041259765625, 1e-12);
}

TEST(Wilcoxon, ZerosAreLeftOutAndTiesShareTheirRank) {
  const SignedRank result = wilcoxon({0, 2, -2, 5, 0});
  EXPECT_EQ(result.n, 3);
  EXPECT_EQ(result.zeros, 2);
  EXPECT_DOUBLE_EQ(result.w_plus, 4.5);
  EXPECT_DOUBLE_EQ(result.w_minus, 1.5);
  EXPECT_DOUBLE_EQ(wilcoxon({}).p, 1.0);
  EXPECT_DOUBLE_EQ(wilcoxon({0, 0}).effect, 0.0);
}

TEST(Wilcoxon, OfOneSidedSamples) {
  const SignedRank result = wilcoxon({1, 2, 3, 4, 5, 6, 7, 8, 9, kInfinite});
  EXPECT_NEAR(result.p, 2.0 / 1024.0, 1e-15);
  EXPECT_DOUBLE_EQ(result.effect, 1.0);
}

/// All signs in turn.
double enumerated_p(const std::vector<double>& differences) {
  const SignedRank seen = wilcoxon(differences);
  std::vector<double> sizes;
  for (const double d : differences) {
    if (d != 0.0) sizes.push_back(std::abs(d));
  }
  const std::size_t all = std::size_t{1} << sizes.size();
  std::size_t as_far = 0;
  for (std::size_t signs = 0; signs < all; ++signs) {
    std::vector<double> signed_sizes = sizes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if ((signs >> i & 1U) != 0) signed_sizes[i] = -signed_sizes[i];
    }
    if (wilcoxon(signed_sizes).w_plus <= std::min(seen.w_plus, seen.w_minus)) ++as_far;
  }
  return std::min(1.0, 2.0 * static_cast<double>(as_far) / static_cast<double>(all));
}

RC_GTEST_PROP(Wilcoxon, ExactIsWhatAllSignsGive, ()) {
  const auto whole = *rc::gen::resize(8, rc::gen::container<std::vector<int>>(rc::gen::inRange(-4, 5)));
  std::vector<double> differences(whole.begin(), whole.end());
  if (differences.size() > 9) differences.resize(9);
  RC_ASSERT(std::abs(wilcoxon(differences).p - enumerated_p(differences)) < 1e-12);
}

TEST(Wilcoxon, TheNormalDistributionTakesOverSmoothly) {
  RandomStream random(3, "pairs");
  std::vector<double> differences;
  for (int i = 0; i < kExactPairs; ++i) differences.push_back(random.normal() + 0.1);
  const SignedRank exact = wilcoxon(differences);
  differences.push_back(1e-9);  // the smallest rank
  const SignedRank normal = wilcoxon(differences);
  EXPECT_TRUE(exact.exact);
  EXPECT_FALSE(normal.exact);
  EXPECT_NEAR(normal.p, exact.p, 0.02 * exact.p + 1e-3);
}

}  // namespace
}  // namespace amiss::experiment
