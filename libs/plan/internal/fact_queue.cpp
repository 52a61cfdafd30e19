#include "plan/internal/fact_queue.hpp"

#include <algorithm>
#include <functional>

namespace amiss::plan {

void FactQueue::clear() {
  for (std::size_t i = 0; i < used_; ++i) buckets_[i].clear();
  used_ = lowest_ = next_ = in_buckets_ = 0;
  heap_.clear();
}

void FactQueue::push(SearchCost cost, int fact) {
  if (cost < static_cast<SearchCost>(kBuckets)) {
    buckets_[static_cast<std::size_t>(cost)].push_back(fact);
    used_ = std::max(used_, static_cast<std::size_t>(cost) + 1);
    ++in_buckets_;
  } else {
    heap_.emplace_back(cost, fact);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }
}

std::pair<SearchCost, int> FactQueue::pop() {
  if (in_buckets_ > 0) {
    for (; next_ == buckets_[lowest_].size(); ++lowest_) next_ = 0;
    const int fact = buckets_[lowest_][next_++];
    --in_buckets_;
    return {static_cast<SearchCost>(lowest_), fact};
  }
  const std::pair<SearchCost, int> top = heap_.front();
  std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
  heap_.pop_back();
  return top;
}

}  // namespace amiss::plan
