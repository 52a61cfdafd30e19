#include "plan/planner.hpp"

#include "plan/internal/grounding.hpp"
#include "plan/internal/mutex.hpp"
#include "plan/internal/search.hpp"

namespace amiss::plan {
namespace {

using Answer = Result<Solution, NoPlan>;

/// Hill-climbing may use up this part of the states; the rest is left for the complete search.
constexpr std::size_t kClimbingPart = 100;

/// Facts times actions looked at to find facts that exclude each other.
constexpr std::size_t kMutexSteps = 50'000'000;

/// Removes actions whose precondition excludes itself; false when the goal does.
bool prune(Task& task) {
  const ReachablePairs pairs(task, kMutexSteps);
  std::erase_if(task.operators, [&](const Operator& op) { return !pairs.possible(op.precondition); });
  return pairs.possible(task.goal);
}

std::optional<OperatorSequence> search(const StateSpace& space, RelaxedPlanHeuristic& heuristic, const Limits& limits,
                                       SearchCounts& counts) {
  std::optional<OperatorSequence> plan = climb(space, heuristic, limits.max_evaluated_states / kClimbingPart);
  counts.hill_climbing_sufficed = plan.has_value();
  if (!plan) plan = best_first(space, heuristic, limits.max_evaluated_states);
  return plan;
}

Plan to_plan(const Domain& domain, const Problem& problem, const Task& task, const OperatorSequence& operators) {
  Plan plan;
  for (const int number : operators) {
    const Operator& op = task.operators[static_cast<std::size_t>(number)];
    plan.cost += op.cost;
    if (op.action < 0) continue;
    Step step{domain.actions[static_cast<std::size_t>(op.action)].name, {}};
    for (const int object : op.arguments)
      step.arguments.push_back(problem.objects[static_cast<std::size_t>(object)].name);
    plan.steps.push_back(std::move(step));
  }
  return plan;
}

}  // namespace

Answer solve(const Domain& domain, const Problem& problem, const Limits& limits) {
  SearchCounts counts;
  const auto none = [&](NoPlan::Reason reason, std::string sentence) {
    return Answer::failure({reason, std::move(sentence), counts});
  };
  const std::string unsolvable = "the problem '" + problem.name + "' has no plan: ";
  try {
    Task task = ground(domain, problem, limits.max_ground_actions);
    counts.ground_actions = task.operators.size();
    counts.facts = task.fact_count;
    if (!task.goal_reachable) {
      return none(NoPlan::Reason::kUnsolvable, unsolvable + "its goal is out of reach of all actions");
    }
    if (!prune(task)) {
      return none(NoPlan::Reason::kUnsolvable, unsolvable + "what its goal asks for cannot hold together");
    }
    const StateSpace space(task);
    RelaxedPlanHeuristic heuristic(space, problem.minimize_cost, counts.evaluated_states);
    std::optional<OperatorSequence> plan = search(space, heuristic, limits, counts);
    if (!plan) return none(NoPlan::Reason::kUnsolvable, unsolvable + "no state that can be reached meets its goal");
    counts.first_length = plan->size();
    return Solution{to_plan(domain, problem, task, improve(space, std::move(*plan), limits.improvement_states)),
                    counts};
  } catch (const LimitReached& limit) {
    return none(NoPlan::Reason::kLimitReached, "the problem '" + problem.name + "' is not decided: " + limit.sentence);
  }
}

}  // namespace amiss::plan
