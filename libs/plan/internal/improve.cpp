// Action elimination and plan neighbourhood graph search: Nakhost and Mueller, Action Elimination and Plan Neighborhood
// Graph Search, ICAPS 2010.
#include <algorithm>
#include <functional>
#include <queue>

#include "plan/internal/search.hpp"

namespace amiss::plan {
namespace {

/// What plans are compared by: cost, and length among plans of the same cost.
struct Price {
  double cost = 0;
  std::size_t length = 0;
  auto operator<=>(const Price&) const = default;
  [[nodiscard]] Price plus(const Operator& op) const { return {cost + op.cost, length + 1}; }
};

/// The plan without step `left_out` and without all later steps that then cannot be done; absent when the goal is
/// missed so.
std::optional<OperatorSequence> without(const StateSpace& space, const OperatorSequence& plan, std::size_t left_out,
                                        State state) {
  OperatorSequence rest(plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(left_out));
  for (std::size_t i = left_out + 1; i < plan.size(); ++i) {
    if (!space.is_applicable(state, plan[i])) continue;
    state = space.successor(state, plan[i]);
    rest.push_back(plan[i]);
  }
  if (!space.is_goal(state)) return std::nullopt;
  return rest;
}

OperatorSequence eliminate_actions(const StateSpace& space, OperatorSequence plan) {
  State state = space.initial();
  for (std::size_t i = 0; i < plan.size();) {
    if (std::optional<OperatorSequence> shorter = without(space, plan, i, state)) {
      plan = std::move(*shorter);
    } else {
      state = space.successor(state, plan[i++]);
    }
  }
  return plan;
}

/// The states near a plan and all actions between them.
class Neighbourhood {
 public:
  Neighbourhood(const StateSpace& space, const OperatorSequence& plan) : space_(space) {
    State state = space.initial();
    add(state);
    for (const int op : plan) {
      state = space.successor(state, op);
      add(state);
    }
  }

  /// Breadth first from all states of the plan until `steps` successors are generated; returns how many were.
  std::size_t expand(std::size_t steps) {
    std::size_t generated = 0;
    for (std::size_t number = 0; number < table_.size() && generated < steps; ++number) {
      const State state = table_[static_cast<int>(number)];
      for (const int op : space_.applicable(state)) {
        const int next = add(space_.successor(state, op));
        edges_[number].push_back({op, next});
        ++generated;
      }
    }
    return generated;
  }

  /// Dijkstra from the initial state over the states expanded; absent where they do not lead to the goal.
  [[nodiscard]] std::optional<OperatorSequence> best_plan() const {
    using Entry = std::pair<Price, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::vector<std::optional<Price>> prices(table_.size());
    std::vector<Origin> origins(table_.size());
    prices[0] = Price{};
    open.push({Price{}, 0});
    while (!open.empty()) {
      const auto [price, number] = open.top();
      open.pop();
      if (price != prices[static_cast<std::size_t>(number)]) continue;
      if (space_.is_goal(table_[number])) return path_to(number, origins);
      for (const Edge& edge : edges_[static_cast<std::size_t>(number)]) {
        std::optional<Price>& known = prices[static_cast<std::size_t>(edge.to)];
        const Price through = price.plus(space_.op(edge.op));
        if (known && *known <= through) continue;
        known = through;
        origins[static_cast<std::size_t>(edge.to)] = {number, edge.op};
        open.push({through, edge.to});
      }
    }
    return std::nullopt;
  }

 private:
  struct Edge {
    int op, to;
  };

  int add(const State& state) {
    const auto [number, is_new] = table_.insert(state);
    if (is_new) edges_.emplace_back();
    return number;
  }

  const StateSpace& space_;
  StateTable table_;
  std::vector<std::vector<Edge>> edges_;  // by state
};

Price price_of(const StateSpace& space, const OperatorSequence& plan) {
  Price price;
  for (const int op : plan) price = price.plus(space.op(op));
  return price;
}

}  // namespace

OperatorSequence improve(const StateSpace& space, OperatorSequence plan, std::size_t steps) {
  if (steps == 0) return plan;
  plan = eliminate_actions(space, std::move(plan));
  constexpr std::size_t kFirstSteps = 2000;
  for (std::size_t width = kFirstSteps; width <= steps;) {
    Neighbourhood neighbourhood(space, plan);
    const std::size_t generated = neighbourhood.expand(width);
    std::optional<OperatorSequence> better = neighbourhood.best_plan();
    steps -= std::min(steps, std::max<std::size_t>(generated, 1));
    const bool is_better = better && price_of(space, *better) < price_of(space, plan);
    if (is_better) plan = std::move(*better);
    if (!is_better && generated < width) break;  // all states are known: nothing better exists
    if (!is_better) width *= 2;
  }
  return plan;
}

}  // namespace amiss::plan
