// The FF planner: (Domain, Problem) -> Plan, or the reason why there is none.
//
// Grounding over what is reachable, relaxed-plan heuristic, enforced hill-climbing over helpful actions, best-first
// search where that fails (complete: it proves that there is no plan), then the plan is shortened. Goes by cost where
// the problem minimizes total-cost, otherwise by length. Deterministic: bounded by counts, never by the clock.
// Thesis 4.2.3; Hoffmann and Nebel, The FF planning system, JAIR 14 (2001).
#pragma once

#include <cstddef>

#include "core/result.hpp"
#include "plan/plan.hpp"
#include "plan/problem.hpp"

namespace amiss::plan {

struct Limits {
  std::size_t max_ground_actions = 2'000'000;    // actions with objects in place of variables
  std::size_t max_evaluated_states = 1'000'000;  // states whose heuristic is computed until the first plan
  std::size_t improvement_states = 100'000;      // states looked at to shorten a plan that was found; 0: none
};

/// What the search did; evidence beside the plan or beside the reason for having none.
struct SearchCounts {
  std::size_t ground_actions = 0;
  std::size_t facts = 0;
  std::size_t evaluated_states = 0;
  bool hill_climbing_sufficed = false;
  std::size_t first_length = 0;  // steps before shortening
};

struct Solution {
  Plan plan;
  SearchCounts counts;
};

struct NoPlan {
  enum class Reason { kUnsolvable, kLimitReached };
  Reason reason = Reason::kUnsolvable;
  std::string sentence;
  SearchCounts counts;
};

[[nodiscard]] Result<Solution, NoPlan> solve(const Domain& domain, const Problem& problem, const Limits& limits = {});

}  // namespace amiss::plan
