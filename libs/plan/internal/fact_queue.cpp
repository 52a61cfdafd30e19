#include "plan/internal/fact_queue.hpp"

#include <functional>

namespace amiss::plan {

void FactQueue::push_heap(SearchCost cost, int fact) {
  heap_.emplace_back(cost, fact);
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

std::pair<SearchCost, int> FactQueue::pop_heap() {
  const std::pair<SearchCost, int> top = heap_.front();
  std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
  heap_.pop_back();
  return top;
}

}  // namespace amiss::plan
