// (Domain, Problem) -> Task: reachable actions only, conditions in disjunctive normal form, negations compiled away,
// facts that never change or never matter removed.
//
// Throws LimitReached where that takes more than the limit allows. FF, JAIR 14 (2001), section 4.
#pragma once

#include "plan/internal/reachability.hpp"
#include "plan/internal/task.hpp"

namespace amiss::plan {

[[nodiscard]] Task ground(const Domain& domain, const Problem& problem, std::size_t max_operators);

/// Removes facts, effects and operators that cannot matter: not reachable even without deletes, always true, or of no
/// use to the goal. Renumbers the facts.
[[nodiscard]] Task simplify(Task task);

/// The cost of an action with these objects; absent where the problem gives a function no value.
[[nodiscard]] std::optional<double> cost_of(const Problem& problem, const Action& action, const Bindings& bindings);

}  // namespace amiss::plan
