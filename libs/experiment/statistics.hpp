// What samples say without a guess at how they are spread. Values may be infinite (a search that found not all took
// longer than any other); not one may be NaN, and no sample may be empty unless it says so.
#pragma once

#include <vector>

#include "core/random.hpp"

namespace amiss::experiment {

/// Linear between the order statistics (type 7 of Hyndman and Fan 1996); midway between -inf and inf is 0.
[[nodiscard]] double quantile(std::vector<double> values, double p);

struct Quartiles {
  double q1 = 0.0, median = 0.0, q3 = 0.0;
};
[[nodiscard]] Quartiles quartiles(const std::vector<double>& values);

struct Interval {
  double low = 0.0, high = 0.0;
};

/// 95 % interval of the median: percentiles of the medians of samples drawn with replacement (Efron 1979).
[[nodiscard]] Interval bootstrap_median(const std::vector<double>& values, RandomStream& random, int resamples = 10000);

/// Wilcoxon's signed-rank test that differences lie symmetrically about 0 (Wilcoxon 1945), two-sided.
struct SignedRank {
  int n = 0, zeros = 0;                // differences that count; zeros are left out, as Wilcoxon does
  double w_plus = 0.0, w_minus = 0.0;  // sums of the ranks of the positive and negative ones; ties share the mean rank
  double p = 1.0;
  bool exact = true;  // up to kExactPairs from all 2^n signs of these very ranks, beyond from the normal distribution
  /// Matched-pairs rank-biserial correlation (Kerby 2014): (w_plus - w_minus) / (w_plus + w_minus), 1 when all
  /// differences are positive, 0 without any.
  double effect = 0.0;
};
inline constexpr int kExactPairs = 200;
/// An empty sample is allowed: p = 1.
[[nodiscard]] SignedRank wilcoxon(const std::vector<double>& differences);

}  // namespace amiss::experiment
