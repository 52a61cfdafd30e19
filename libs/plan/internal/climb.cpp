#include <functional>
#include <queue>

#include "plan/internal/search.hpp"

namespace amiss::plan {
namespace {

/// States around one state, the cheapest to reach first.
class LocalSearch {
 public:
  LocalSearch(const StateSpace& space, RelaxedPlanHeuristic& heuristic, std::size_t max_evaluations)
      : space_(space), heuristic_(heuristic), max_evaluations_(max_evaluations) {}

  struct Step {
    State state;
    Estimate estimate;
    OperatorSequence operators;
  };

  /// The nearest state that is estimated to be nearer to the goal.
  std::optional<Step> better(const State& from, const Estimate& estimate) {
    add(from, -1, -1, 0);
    while (!open_.empty() && heuristic_.evaluations() < max_evaluations_) {
      const auto [cost, number] = open_.top();
      open_.pop();
      const State state = table_[number];
      if (number == 0) {
        expand(state, number, cost, estimate.helpful);
        continue;
      }
      std::optional<Estimate> here = heuristic_.estimate(state);
      if (!here) continue;
      if (here->length < estimate.length) return Step{state, std::move(*here), path_to(number, origins_)};
      expand(state, number, cost, here->helpful);
    }
    return std::nullopt;
  }

 private:
  void add(const State& state, int parent, int op, SearchCost cost) {
    const auto [number, is_new] = table_.insert(state);
    if (!is_new) return;
    origins_.push_back({parent, op});
    open_.emplace(cost, number);
  }

  void expand(const State& state, int number, SearchCost cost, const std::vector<int>& operators) {
    for (const int op : operators) add(space_.successor(state, op), number, op, cost + heuristic_.cost(op));
  }

  const StateSpace& space_;
  RelaxedPlanHeuristic& heuristic_;
  std::size_t max_evaluations_;
  StateTable table_;
  std::vector<Origin> origins_;
  std::priority_queue<std::pair<SearchCost, int>, std::vector<std::pair<SearchCost, int>>, std::greater<>> open_;
};

}  // namespace

std::optional<OperatorSequence> climb(const StateSpace& space, RelaxedPlanHeuristic& heuristic,
                                      std::size_t max_evaluations) {
  OperatorSequence plan;
  State state = space.initial();
  std::optional<Estimate> estimate = heuristic.estimate(state);
  if (!estimate) return std::nullopt;
  while (estimate->length > 0) {
    auto step = LocalSearch(space, heuristic, max_evaluations).better(state, *estimate);
    if (!step) return std::nullopt;
    plan.insert(plan.end(), step->operators.begin(), step->operators.end());
    state = std::move(step->state);
    estimate = std::move(step->estimate);
  }
  return plan;
}

}  // namespace amiss::plan
