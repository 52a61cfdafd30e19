// Searching the state space for the first plan.
#pragma once

#include "plan/internal/budget.hpp"
#include "plan/internal/heuristic.hpp"

namespace amiss::plan {

using OperatorSequence = std::vector<int>;

/// How a state was reached; the first state, number 0, has no parent.
struct Origin {
  int parent = -1, op = -1;
};

/// Operators on the way to a state.
[[nodiscard]] OperatorSequence path_to(int state, const std::vector<Origin>& origins);

/// Enforced hill-climbing: from each state the nearest one with a smaller estimate, over helpful actions only. Absent
/// where it gets stuck or has evaluated as many states as allowed. FF, JAIR 14 (2001), section 3.
[[nodiscard]] std::optional<OperatorSequence> climb(const StateSpace& space, RelaxedPlanHeuristic& heuristic,
                                                    std::size_t max_evaluations);

/// Greedy best-first search by landmarks left, then by the length of the relaxed plan. States reached by helpful
/// actions have a queue of their own, which is served more often while it makes progress (Richter and Helmert, ICAPS
/// 2009). Complete: absent means that there is no plan. Throws LimitReached after max_evaluations states.
[[nodiscard]] std::optional<OperatorSequence> best_first(const StateSpace& space, RelaxedPlanHeuristic& heuristic,
                                                         std::size_t max_evaluations);

/// A plan that is never longer or dearer: without needless actions, and the best one in the neighbourhood of the
/// states along it. `steps` bounds the successor states generated.
[[nodiscard]] OperatorSequence improve(const StateSpace& space, OperatorSequence plan, std::size_t steps);

}  // namespace amiss::plan
