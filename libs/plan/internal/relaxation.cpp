#include "plan/internal/relaxation.hpp"

namespace amiss::plan {

Relaxation::Relaxation(const Task& task) : needed_by_(task.fact_count) {
  for (const Operator& op : task.operators) {
    for (const GroundEffect& effect : op.effects) {
      const std::size_t number = adds_.size();
      for (const int fact : op.precondition) needed_by_[static_cast<std::size_t>(fact)].push_back(number);
      for (const int fact : effect.condition) needed_by_[static_cast<std::size_t>(fact)].push_back(number);
      needs_.push_back(op.precondition.size() + effect.condition.size());
      adds_.push_back(effect.adds);
      for (const int fact : effect.deletes) {
        const int complement = task.complement[static_cast<std::size_t>(fact)];
        if (complement != kNoComplement) adds_.back().push_back(complement);
      }
      size_ += 1 + needs_.back();
    }
  }
}

std::vector<bool> Relaxation::reachable(const std::vector<int>& from, int barred) const {
  std::vector<bool> result(needed_by_.size(), false);
  std::vector<std::size_t> missing = needs_;
  std::vector<int> open;
  const auto reach = [&](int fact) {
    if (fact == barred || result[static_cast<std::size_t>(fact)]) return;
    result[static_cast<std::size_t>(fact)] = true;
    open.push_back(fact);
  };
  const auto fire = [&](std::size_t effect) {
    for (const int fact : adds_[effect]) reach(fact);
  };
  for (const int fact : from) reach(fact);
  for (std::size_t effect = 0; effect < missing.size(); ++effect) {
    if (missing[effect] == 0) fire(effect);
  }
  while (!open.empty()) {
    const int fact = open.back();
    open.pop_back();
    for (const std::size_t effect : needed_by_[static_cast<std::size_t>(fact)]) {
      if (--missing[effect] == 0) fire(effect);
    }
  }
  return result;
}

}  // namespace amiss::plan
