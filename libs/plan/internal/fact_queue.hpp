// The open list of the relaxed exploration: small costs, which are most, in buckets; the others in a heap.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace amiss::plan {

/// Cost of an action as searches count it: at least 1, so that free actions are not thought to be nothing.
using SearchCost = std::int64_t;

class FactQueue {
 public:
  void clear() {
    for (std::size_t i = 0; i < used_; ++i) buckets_[i].clear();
    used_ = lowest_ = next_ = in_buckets_ = 0;
    heap_.clear();
  }
  [[nodiscard]] bool empty() const { return in_buckets_ == 0 && heap_.empty(); }
  /// `cost` must not be less than that of the last pop().
  void push(SearchCost cost, int fact) {
    if (cost >= static_cast<SearchCost>(kBuckets)) return push_heap(cost, fact);
    buckets_[static_cast<std::size_t>(cost)].push_back(fact);
    used_ = std::max(used_, static_cast<std::size_t>(cost) + 1);
    ++in_buckets_;
  }
  std::pair<SearchCost, int> pop() {
    if (in_buckets_ == 0) return pop_heap();
    for (; next_ == buckets_[lowest_].size(); ++lowest_) next_ = 0;
    --in_buckets_;
    return {static_cast<SearchCost>(lowest_), buckets_[lowest_][next_++]};
  }

 private:
  static constexpr std::size_t kBuckets = 256;

  void push_heap(SearchCost cost, int fact);
  std::pair<SearchCost, int> pop_heap();

  std::array<std::vector<int>, kBuckets> buckets_;
  std::size_t used_ = 0;               // buckets from here on are empty
  std::size_t lowest_ = 0, next_ = 0;  // what comes next: first in, first out within a bucket
  std::size_t in_buckets_ = 0;
  std::vector<std::pair<SearchCost, int>> heap_;
};

}  // namespace amiss::plan
