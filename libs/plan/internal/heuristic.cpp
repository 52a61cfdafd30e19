#include "plan/internal/heuristic.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace amiss::plan {
namespace {

std::size_t index(int number) { return static_cast<std::size_t>(number); }

void sort_unique(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

RelaxedPlanHeuristic::RelaxedPlanHeuristic(const StateSpace& space, bool minimize_cost)
    : space_(space), needed_by_(space.task().fact_count), added_by_(space.task().fact_count) {
  const std::vector<Operator>& operators = space.task().operators;
  for (std::size_t number = 0; number < operators.size(); ++number) {
    operator_cost_.push_back(minimize_cost ? 1 + std::llround(operators[number].cost) : 1);
    for (const GroundEffect& effect : operators[number].effects) add_relaxed(static_cast<int>(number), effect);
  }
  fact_cost_.resize(space.task().fact_count);
  supporter_.resize(space.task().fact_count);
  missing_.resize(relaxed_.size());
  relaxed_cost_.resize(relaxed_.size());
}

void RelaxedPlanHeuristic::add_relaxed(int op, const GroundEffect& effect) {
  Relaxed relaxed{op, operator_cost_[index(op)], 0, space_.op(op).precondition, effect.adds};
  relaxed.conditions.insert(relaxed.conditions.end(), effect.condition.begin(), effect.condition.end());
  sort_unique(relaxed.conditions);
  relaxed.needs = relaxed.conditions.size();
  for (const int fact : effect.deletes) {
    const int complement = space_.task().complement[index(fact)];
    if (complement != kNoComplement) relaxed.adds.push_back(complement);
  }
  const int number = static_cast<int>(relaxed_.size());
  for (const int fact : relaxed.conditions) needed_by_[index(fact)].push_back(number);
  for (const int fact : relaxed.adds) added_by_[index(fact)].push_back(number);
  if (relaxed.needs == 0) unconditional_.push_back(number);
  relaxed_.push_back(std::move(relaxed));
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
  for (std::size_t i = 0; i < relaxed_.size(); ++i) {
    missing_[i] = relaxed_[i].needs;
    relaxed_cost_[i] = relaxed_[i].base;
  }
  for (int fact = 0; fact < static_cast<int>(fact_cost_.size()); ++fact) {
    if (holds(state, fact)) reach(fact, 0, -1);
  }
  for (const int relaxed : unconditional_) fire(index(relaxed));
}

void RelaxedPlanHeuristic::reach(int fact, SearchCost cost, int supporter) {
  if (cost >= fact_cost_[index(fact)]) return;
  fact_cost_[index(fact)] = cost;
  supporter_[index(fact)] = supporter;
  open_.emplace_back(cost, fact);
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
}

void RelaxedPlanHeuristic::fire(std::size_t relaxed) {
  const SearchCost cost = std::min(relaxed_cost_[relaxed], kLargest);
  for (const int fact : relaxed_[relaxed].adds) reach(fact, cost, static_cast<int>(relaxed));
}

/// Dijkstra over facts until the goal's are settled; false where they cannot be reached.
bool RelaxedPlanHeuristic::explore() {
  const std::vector<int>& goal = space_.task().goal;
  std::size_t goals_left = goal.size();
  while (!open_.empty() && goals_left > 0) {
    const auto [cost, fact] = open_.front();
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    open_.pop_back();
    if (cost != fact_cost_[index(fact)]) continue;
    if (std::binary_search(goal.begin(), goal.end(), fact)) --goals_left;
    for (const int relaxed : needed_by_[index(fact)]) {
      relaxed_cost_[index(relaxed)] = std::min(relaxed_cost_[index(relaxed)] + cost, kLargest);
      if (--missing_[index(relaxed)] == 0) fire(index(relaxed));
    }
  }
  return goals_left == 0;
}

Estimate RelaxedPlanHeuristic::extract(const State& state) {
  Estimate result;
  std::vector<int> open, needed_first, operators;
  std::vector<bool> seen(fact_cost_.size(), false);
  const auto need = [&](int fact) {
    if (seen[index(fact)] || holds(state, fact)) return;
    seen[index(fact)] = true;
    open.push_back(fact);
  };
  for (const int fact : space_.task().goal) need(fact);
  while (!open.empty()) {
    const int fact = open.back();
    open.pop_back();
    const Relaxed& supporter = relaxed_[index(supporter_[index(fact)])];
    operators.push_back(supporter.op);
    if (fact_cost_[index(fact)] == supporter.base) needed_first.push_back(fact);
    for (const int condition : supporter.conditions) need(condition);
  }
  sort_unique(operators);
  result.length = static_cast<int>(operators.size());
  for (const int op : operators) result.cost += cost(op);
  for (const int fact : needed_first) add_helpful(fact, result.helpful);
  sort_unique(result.helpful);
  return result;
}

void RelaxedPlanHeuristic::add_helpful(int fact, std::vector<int>& helpful) const {
  for (const int number : added_by_[index(fact)]) {
    const Relaxed& relaxed = relaxed_[index(number)];
    if (missing_[index(number)] == 0 && relaxed_cost_[index(number)] == relaxed.base) helpful.push_back(relaxed.op);
  }
}

}  // namespace amiss::plan
