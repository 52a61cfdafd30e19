// The open list of the relaxed exploration: small costs, which are most, in buckets; the others in a heap.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace amiss::plan {

/// Cost of an action as searches count it: at least 1, so that free actions are not thought to be nothing.
using SearchCost = std::int64_t;

class FactQueue {
 public:
  void clear();
  [[nodiscard]] bool empty() const { return in_buckets_ == 0 && heap_.empty(); }
  /// `cost` must not be less than that of the last pop().
  void push(SearchCost cost, int fact);
  std::pair<SearchCost, int> pop();

 private:
  static constexpr std::size_t kBuckets = 256;

  std::array<std::vector<int>, kBuckets> buckets_;
  std::size_t used_ = 0;               // buckets from here on are empty
  std::size_t lowest_ = 0, next_ = 0;  // what comes next: first in, first out within a bucket
  std::size_t in_buckets_ = 0;
  std::vector<std::pair<SearchCost, int>> heap_;
};

}  // namespace amiss::plan
