// How far is the goal? The length of a plan for the task without deletes, and the actions that such a plan begins with.
//
// Facts get the cost of reaching them (sum over an action's preconditions: h_add), the plan is picked backwards from
// the goal through each fact's cheapest action. FF, JAIR 14 (2001), sections 4 and 5; cheapest supporters by h_add:
// Keyder and Geffner, ECAI 2008.
#pragma once

#include <optional>

#include "plan/internal/state_space.hpp"

namespace amiss::plan {

/// Cost of an action as searches count it: at least 1, so that free actions are not thought to be nothing.
using SearchCost = std::int64_t;

struct Estimate {
  int length = 0;            // actions in the relaxed plan; 0 exactly where the goal holds
  SearchCost cost = 0;       // their costs
  std::vector<int> helpful;  // operators applicable now that add what the relaxed plan needs first; ascending
};

class RelaxedPlanHeuristic {
 public:
  RelaxedPlanHeuristic(const StateSpace& space, bool minimize_cost);

  /// Absent: a dead end, the goal cannot be reached from here.
  [[nodiscard]] std::optional<Estimate> estimate(const State& state);
  [[nodiscard]] SearchCost cost(int op) const { return operator_cost_[static_cast<std::size_t>(op)]; }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

 private:
  static constexpr SearchCost kUnreached = INT64_MAX;
  static constexpr SearchCost kLargest = std::int64_t{1} << 50;  // sums stop growing here

  /// An effect of an operator without what it deletes.
  struct Relaxed {
    int op = 0;
    SearchCost base = 0;
    std::size_t needs = 0;
    std::vector<int> conditions, adds;
  };

  void add_relaxed(int op, const GroundEffect& effect);
  void reset(const State& state);
  void reach(int fact, SearchCost cost, int supporter);
  void fire(std::size_t relaxed);
  [[nodiscard]] bool explore();
  [[nodiscard]] Estimate extract(const State& state);
  void add_helpful(int fact, std::vector<int>& helpful) const;

  const StateSpace& space_;
  std::vector<SearchCost> operator_cost_;
  std::vector<Relaxed> relaxed_;
  std::vector<std::vector<int>> needed_by_, added_by_;  // by fact: indices into relaxed_
  std::vector<int> unconditional_;

  // The exploration at work.
  std::vector<SearchCost> fact_cost_;
  std::vector<int> supporter_;  // by fact: index into relaxed_, -1 where it holds in the state
  std::vector<std::size_t> missing_;
  std::vector<SearchCost> relaxed_cost_;
  std::vector<std::pair<SearchCost, int>> open_;  // heap
  std::size_t evaluations_ = 0;
};

}  // namespace amiss::plan
