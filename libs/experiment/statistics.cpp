#include "experiment/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace amiss::experiment {

namespace {

double quantile_of_sorted(const std::vector<double>& sorted, double p) {
  assert(!sorted.empty());
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(below);
  if (part <= 0.0 || sorted[below] == sorted[below + 1]) return sorted[below];
  const double low = sorted[below], high = sorted[below + 1];
  if (std::isinf(low) && std::isinf(high)) return 0.0;
  return low + part * (high - low);
}

/// Twice the ranks of absolute values that are sorted, so that the mean rank of a tie is a whole number.
std::vector<std::size_t> doubled_ranks(const std::vector<double>& sorted) {
  std::vector<std::size_t> ranks(sorted.size());
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin;
    while (end < sorted.size() && sorted[end] == sorted[begin]) ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[i] = begin + 1 + end;  // first and last rank, one-based
    begin = end;
  }
  return ranks;
}

/// P(sum of the doubled ranks with a positive sign <= sum) when each sign is a fair coin.
double exact_tail(const std::vector<std::size_t>& ranks, std::size_t sum) {
  std::vector<double> chance{1.0};  // of each sum so far
  for (const std::size_t rank : ranks) {
    std::vector<double> next(chance.size() + rank, 0.0);
    for (std::size_t s = 0; s < chance.size(); ++s) {
      next[s] += 0.5 * chance[s];
      next[s + rank] += 0.5 * chance[s];
    }
    chance = std::move(next);
  }
  double tail = 0.0;
  for (std::size_t s = 0; s <= sum && s < chance.size(); ++s) tail += chance[s];
  return tail;
}

/// The same for many pairs: normal, with the correction for continuity; ties lower the variance by themselves.
double normal_tail(const std::vector<std::size_t>& ranks, double w) {
  double mean = 0.0, variance = 0.0;
  for (const std::size_t doubled : ranks) {
    const double rank = 0.5 * static_cast<double>(doubled);
    mean += 0.5 * rank;
    variance += 0.25 * rank * rank;
  }
  return 0.5 * std::erfc((mean - w - 0.5) / std::sqrt(2.0 * variance));
}

}  // namespace

double quantile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  return quantile_of_sorted(values, p);
}

Quartiles quartiles(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  return {quantile_of_sorted(sorted, 0.25), quantile_of_sorted(sorted, 0.5), quantile_of_sorted(sorted, 0.75)};
}

Interval bootstrap_median(const std::vector<double>& values, RandomStream& random, int resamples) {
  std::vector<double> medians, sample(values.size());
  for (int i = 0; i < resamples; ++i) {
    for (double& value : sample) value = values[random.below(values.size())];
    medians.push_back(quantile(sample, 0.5));
  }
  std::sort(medians.begin(), medians.end());
  return {quantile_of_sorted(medians, 0.025), quantile_of_sorted(medians, 0.975)};
}

SignedRank wilcoxon(const std::vector<double>& differences) {
  std::vector<double> signed_values;
  std::copy_if(differences.begin(), differences.end(), std::back_inserter(signed_values),
               [](double d) { return d != 0.0; });
  std::sort(signed_values.begin(), signed_values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  std::vector<double> sizes;
  for (const double d : signed_values) sizes.push_back(std::abs(d));
  const std::vector<std::size_t> ranks = doubled_ranks(sizes);
  std::size_t plus = 0, minus = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i) (signed_values[i] > 0.0 ? plus : minus) += ranks[i];

  SignedRank result;
  result.n = static_cast<int>(ranks.size());
  result.zeros = static_cast<int>(differences.size() - ranks.size());
  result.w_plus = 0.5 * static_cast<double>(plus);
  result.w_minus = 0.5 * static_cast<double>(minus);
  if (ranks.empty()) return result;
  result.exact = result.n <= kExactPairs;
  const std::size_t less = std::min(plus, minus);
  const double tail = result.exact ? exact_tail(ranks, less) : normal_tail(ranks, 0.5 * static_cast<double>(less));
  result.p = std::min(1.0, 2.0 * tail);
  result.effect = (result.w_plus - result.w_minus) / (result.w_plus + result.w_minus);
  return result;
}

}  // namespace amiss::experiment
