// Carries a plan out in thought: is every precondition true when its step begins, and the goal in the end?
//
// Works on the domain as read, with sets of atoms, and shares nothing with the planner's grounding and search, so that
// each checks the other. Thesis 4.2.3.
#pragma once

#include <optional>

#include "core/result.hpp"
#include "plan/plan.hpp"
#include "plan/problem.hpp"

namespace amiss::plan {

/// Where a plan breaks: the step (1 is the first; absent: the goal at the end), the literal that is not so, and both
/// in a sentence.
struct PlanFault {
  std::optional<std::size_t> step;
  std::string literal;  // "(at truck-1 depot)" or "(not (handempty))"; empty where a step is no action at all
  std::string sentence;
};

/// The plan's cost: sum of action costs where the problem minimizes total-cost, else the number of steps.
[[nodiscard]] Result<double, PlanFault> validate(const Domain& domain, const Problem& problem, const Plan& plan);

}  // namespace amiss::plan
