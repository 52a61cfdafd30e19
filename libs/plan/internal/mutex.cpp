#include "plan/internal/mutex.hpp"

#include <algorithm>

namespace amiss::plan {

ReachablePairs::ReachablePairs(const Task& task, std::size_t steps) : facts_(task.fact_count) {
  constexpr std::size_t kMostFacts = 3000;
  if (facts_ > kMostFacts || facts_ * task.operators.size() > steps) {
    pairs_.assign(facts_ > kMostFacts ? 0 : facts_ * facts_, true);
    return;
  }
  pairs_.assign(facts_ * facts_, false);
  for (const int a : task.init) {
    for (const int b : task.init) mark(a, b);
  }
  const std::vector<Action> actions = actions_of(task);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Action& action : actions) changed = apply(action) || changed;
    const std::size_t round = facts_ * actions.size();
    if (changed && round > steps) {
      pairs_.assign(facts_ * facts_, true);
      return;
    }
    steps -= std::min(steps, round);
  }
}

std::vector<ReachablePairs::Action> ReachablePairs::actions_of(const Task& task) {
  std::vector<Action> actions;
  for (const Operator& op : task.operators) {
    Action always{op.precondition, {}, {}};
    std::vector<int> all_adds;  // whatever any effect may add, a complement for what it deletes
    for (const GroundEffect& effect : op.effects) {
      all_adds.insert(all_adds.end(), effect.adds.begin(), effect.adds.end());
      for (const int fact : effect.deletes) {
        const int complement = task.complement[static_cast<std::size_t>(fact)];
        if (complement != kNoComplement) all_adds.push_back(complement);
      }
      if (!effect.condition.empty()) continue;
      always.deletes.insert(always.deletes.end(), effect.deletes.begin(), effect.deletes.end());
      for (const int fact : effect.adds) {
        const int complement = task.complement[static_cast<std::size_t>(fact)];
        if (complement != kNoComplement) always.deletes.push_back(complement);
      }
    }
    always.adds = std::move(all_adds);
    actions.push_back(std::move(always));
  }
  return actions;
}

bool ReachablePairs::has(int a, int b) const {
  return pairs_[static_cast<std::size_t>(a) * facts_ + static_cast<std::size_t>(b)];
}

bool ReachablePairs::mark(int a, int b) {
  if (has(a, b)) return false;
  pairs_[static_cast<std::size_t>(a) * facts_ + static_cast<std::size_t>(b)] = true;
  pairs_[static_cast<std::size_t>(b) * facts_ + static_cast<std::size_t>(a)] = true;
  return true;
}

bool ReachablePairs::possible(const std::vector<int>& facts) const {
  if (pairs_.empty()) return true;
  return std::all_of(facts.begin(), facts.end(), [&](int fact) { return possible_with(fact, facts); });
}

bool ReachablePairs::possible_with(int fact, const std::vector<int>& facts) const {
  return std::all_of(facts.begin(), facts.end(), [&](int other) { return has(fact, other); });
}

/// Added facts hold with one another, and with whatever may hold beside the precondition and is not deleted.
bool ReachablePairs::apply(const Action& action) {
  if (!possible(action.needs)) return false;
  bool changed = false;
  for (const int a : action.adds) {
    for (const int b : action.adds) changed = mark(a, b) || changed;
  }
  for (int kept = 0; kept < static_cast<int>(facts_); ++kept) {
    const auto is_new = [&](int added) { return !has(added, kept); };
    if (!has(kept, kept) || std::none_of(action.adds.begin(), action.adds.end(), is_new)) continue;
    if (std::find(action.deletes.begin(), action.deletes.end(), kept) != action.deletes.end()) continue;
    if (!possible_with(kept, action.needs)) continue;
    for (const int added : action.adds) changed = mark(added, kept) || changed;
  }
  return changed;
}

}  // namespace amiss::plan
