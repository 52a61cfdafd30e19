// How far is the goal? The length of a plan for the task without deletes, and the actions that such a plan begins with.
//
// Facts get the cost of reaching them (sum over an action's preconditions: h_add), the plan is picked backwards from
// the goal through each fact's cheapest action. FF, JAIR 14 (2001), sections 4 and 5; cheapest supporters by h_add:
// Keyder and Geffner, ECAI 2008.
#pragma once

#include <optional>
#include <span>

#include "plan/internal/fact_queue.hpp"
#include "plan/internal/state_space.hpp"

namespace amiss::plan {

struct Estimate {
  int length = 0;            // actions in the relaxed plan; 0 exactly where the goal holds
  SearchCost cost = 0;       // their costs
  std::vector<int> helpful;  // operators applicable now that add what the relaxed plan needs first; ascending
};

class RelaxedPlanHeuristic {
 public:
  /// Counts in `evaluations` the states that it estimates.
  RelaxedPlanHeuristic(const StateSpace& space, bool minimize_cost, std::size_t& evaluations);

  /// Absent: a dead end, the goal cannot be reached from here.
  [[nodiscard]] std::optional<Estimate> estimate(const State& state);
  [[nodiscard]] SearchCost cost(int op) const { return operator_cost_[static_cast<std::size_t>(op)]; }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

 private:
  static constexpr SearchCost kUnreached = INT64_MAX;
  static constexpr SearchCost kLargest = std::int64_t{1}
                                         << 40;  // costs stop growing here, so that sums of millions of them fit

  /// An effect of an operator without what it deletes: when all its conditions are reached, so is what it adds.
  struct Relaxed {
    int op = 0;
    SearchCost base = 0;
    int first_condition = 0, first_add = 0;  // into conditions_ and adds_, up to those of the next one
  };
  struct Progress {
    SearchCost cost = 0;  // the operator's and those of the conditions reached
    int missing = 0;      // conditions not reached yet
  };

  void add_relaxed(int op, const GroundEffect& effect);
  void index_conditions();
  [[nodiscard]] std::span<const int> conditions(int relaxed) const;
  [[nodiscard]] std::span<const int> adds(int relaxed) const;
  [[nodiscard]] std::span<const int> needed_by(int fact) const;
  void reset(const State& state);
  void reach(int fact, SearchCost cost, int supporter);
  void fire(int relaxed);
  [[nodiscard]] bool explore();
  [[nodiscard]] Estimate extract(const State& state);
  void add_helpful(int fact, std::vector<int>& helpful) const;

  const StateSpace& space_;
  std::vector<SearchCost> operator_cost_;
  std::vector<Relaxed> relaxed_;  // and one more behind the last
  std::vector<int> conditions_, adds_;
  std::vector<int> first_needed_by_, needed_by_;  // by fact: a part of needed_by_, indices into relaxed_
  std::vector<std::vector<int>> added_by_;        // by fact: indices into relaxed_
  std::vector<int> unconditional_;
  std::vector<Progress> at_first_;
  std::vector<bool> is_goal_;

  // The exploration at work.
  std::vector<SearchCost> fact_cost_;
  std::vector<int> supporter_;  // by fact: index into relaxed_, -1 where it holds in the state
  std::vector<Progress> progress_;
  FactQueue open_;
  std::vector<int> complete_;  // indices into relaxed_, whose last missing condition was just reached
  std::vector<bool> seen_;
  std::size_t& evaluations_;
};

}  // namespace amiss::plan
