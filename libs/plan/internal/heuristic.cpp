#include "plan/internal/heuristic.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace amiss::plan {
namespace {

std::size_t index(int number) { return static_cast<std::size_t>(number); }

void sort_unique(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

RelaxedPlanHeuristic::RelaxedPlanHeuristic(const StateSpace& space, bool minimize_cost, std::size_t& evaluations)
    : space_(space),
      added_by_(space.task().fact_count),
      is_goal_(space.task().fact_count, false),
      fact_cost_(space.task().fact_count),
      supporter_(space.task().fact_count),
      seen_(space.task().fact_count),
      evaluations_(evaluations) {
  const std::vector<Operator>& operators = space.task().operators;
  for (std::size_t number = 0; number < operators.size(); ++number) {
    operator_cost_.push_back(minimize_cost ? 1 + std::llround(operators[number].cost) : 1);
    for (const GroundEffect& effect : operators[number].effects) add_relaxed(static_cast<int>(number), effect);
  }
  relaxed_.push_back({0, 0, static_cast<int>(conditions_.size()), static_cast<int>(adds_.size())});
  index_conditions();
  for (const int fact : space.task().goal) is_goal_[index(fact)] = true;
}

void RelaxedPlanHeuristic::add_relaxed(int op, const GroundEffect& effect) {
  const int number = static_cast<int>(relaxed_.size());
  relaxed_.push_back({op, cost(op), static_cast<int>(conditions_.size()), static_cast<int>(adds_.size())});
  std::vector<int> needed = space_.op(op).precondition;
  needed.insert(needed.end(), effect.condition.begin(), effect.condition.end());
  sort_unique(needed);
  conditions_.insert(conditions_.end(), needed.begin(), needed.end());
  adds_.insert(adds_.end(), effect.adds.begin(), effect.adds.end());
  for (const int fact : effect.deletes) {
    const int complement = space_.task().complement[index(fact)];
    if (complement != kNoComplement) adds_.push_back(complement);
  }
  for (std::size_t i = index(relaxed_.back().first_add); i < adds_.size(); ++i) {
    added_by_[index(adds_[i])].push_back(number);
  }
  if (needed.empty()) unconditional_.push_back(number);
  at_first_.push_back({cost(op), static_cast<int>(needed.size())});
}

void RelaxedPlanHeuristic::index_conditions() {
  std::vector<std::vector<int>> by_fact(space_.task().fact_count);
  for (int number = 0; number < static_cast<int>(at_first_.size()); ++number) {
    for (const int fact : conditions(number)) by_fact[index(fact)].push_back(number);
  }
  std::size_t most = 0;
  for (const std::vector<int>& numbers : by_fact) {
    most = std::max(most, numbers.size());
    first_needed_by_.push_back(static_cast<int>(needed_by_.size()));
    needed_by_.insert(needed_by_.end(), numbers.begin(), numbers.end());
  }
  first_needed_by_.push_back(static_cast<int>(needed_by_.size()));
  complete_.resize(most);
}

std::span<const int> RelaxedPlanHeuristic::conditions(int relaxed) const {
  const int first = relaxed_[index(relaxed)].first_condition;
  return {conditions_.data() + first, index(relaxed_[index(relaxed) + 1].first_condition - first)};
}

std::span<const int> RelaxedPlanHeuristic::adds(int relaxed) const {
  const int first = relaxed_[index(relaxed)].first_add;
  return {adds_.data() + first, index(relaxed_[index(relaxed) + 1].first_add - first)};
}

std::span<const int> RelaxedPlanHeuristic::needed_by(int fact) const {
  const int first = first_needed_by_[index(fact)];
  return {needed_by_.data() + first, index(first_needed_by_[index(fact) + 1] - first)};
}

std::optional<Estimate> RelaxedPlanHeuristic::estimate(const State& state) {
  ++evaluations_;
  reset(state);
  if (!explore()) return std::nullopt;
  return extract(state);
}

void RelaxedPlanHeuristic::reset(const State& state) {
  open_.clear();
  std::fill(fact_cost_.begin(), fact_cost_.end(), kUnreached);
  progress_ = at_first_;
  for (std::size_t word = 0; word < state.size(); ++word) {
    for (std::uint64_t bits = state[word]; bits != 0; bits &= bits - 1) {
      reach(static_cast<int>(word * 64) + std::countr_zero(bits), 0, -1);
    }
  }
  for (const int relaxed : unconditional_) fire(relaxed);
}

inline void RelaxedPlanHeuristic::reach(int fact, SearchCost cost, int supporter) {
  if (cost >= fact_cost_[index(fact)]) return;
  fact_cost_[index(fact)] = cost;
  supporter_[index(fact)] = supporter;
  open_.push(cost, fact);
}

inline void RelaxedPlanHeuristic::fire(int relaxed) {
  const SearchCost cost = std::min(progress_[index(relaxed)].cost, kLargest);
  for (const int fact : adds(relaxed)) reach(fact, cost, relaxed);
}

/// Dijkstra over facts until the goal's are settled; false where they cannot be reached. Most of a search's time goes
/// here: what a fact completes is gathered without a branch, because no processor could guess it.
bool RelaxedPlanHeuristic::explore() {
  std::size_t goals_left = space_.task().goal.size();
  Progress* const progress = progress_.data();
  int* const complete = complete_.data();
  while (!open_.empty() && goals_left > 0) {
    const auto [cost, fact] = open_.pop();
    if (cost != fact_cost_[index(fact)]) continue;
    if (is_goal_[index(fact)]) --goals_left;
    std::size_t count = 0;
    for (const int number : needed_by(fact)) {
      Progress& here = progress[number];
      here.cost += cost;
      complete[count] = number;
      count += --here.missing == 0 ? 1U : 0U;
    }
    for (std::size_t i = 0; i < count; ++i) fire(complete[i]);
  }
  return goals_left == 0;
}

Estimate RelaxedPlanHeuristic::extract(const State& state) {
  Estimate result;
  std::vector<int> open, needed_first, operators;
  std::fill(seen_.begin(), seen_.end(), false);
  const auto need = [&](int fact) {
    if (seen_[index(fact)] || holds(state, fact)) return;
    seen_[index(fact)] = true;
    open.push_back(fact);
  };
  for (const int fact : space_.task().goal) need(fact);
  while (!open.empty()) {
    const int fact = open.back();
    open.pop_back();
    const int supporter = supporter_[index(fact)];
    operators.push_back(relaxed_[index(supporter)].op);
    if (fact_cost_[index(fact)] == relaxed_[index(supporter)].base) needed_first.push_back(fact);
    for (const int condition : conditions(supporter)) need(condition);
  }
  sort_unique(operators);
  result.length = static_cast<int>(operators.size());
  for (const int fact : needed_first) add_helpful(fact, result.helpful);
  sort_unique(result.helpful);
  return result;
}

void RelaxedPlanHeuristic::add_helpful(int fact, std::vector<int>& helpful) const {
  for (const int number : added_by_[index(fact)]) {
    const Progress& progress = progress_[index(number)];
    if (progress.missing == 0 && progress.cost == relaxed_[index(number)].base) {
      helpful.push_back(relaxed_[index(number)].op);
    }
  }
}

}  // namespace amiss::plan
