#include <algorithm>
#include <functional>
#include <queue>

#include "plan/internal/search.hpp"

namespace amiss::plan {
namespace {

class BestFirstSearch {
 public:
  BestFirstSearch(const StateSpace& space, RelaxedPlanHeuristic& heuristic, std::size_t max_evaluations)
      : space_(space), heuristic_(heuristic), max_evaluations_(max_evaluations) {}

  std::optional<OperatorSequence> search() {
    const State first = space_.initial();
    table_.insert(first);
    add_node({});
    push(all_, 0, 0);
    while (!all_.queue.empty() || !helpful_.queue.empty()) {
      const int number = pop();
      if (closed_[static_cast<std::size_t>(number)]) continue;
      closed_[static_cast<std::size_t>(number)] = true;
      const State state = table_[number];
      if (space_.is_goal(state)) return path_to(number, origins_);
      expand(number, state);
    }
    return std::nullopt;
  }

 private:
  using Entry = std::pair<std::pair<int, std::size_t>, int>;  // ((estimate, age), state)
  struct Queue {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::int64_t served = 0;
  };

  void add_node(Origin origin) {
    origins_.push_back(origin);
    closed_.push_back(false);
  }

  void push(Queue& queue, int estimate, int number) { queue.queue.push({{estimate, pushed_++}, number}); }

  int pop() {
    Queue& queue = helpful_.queue.empty() || (!all_.queue.empty() && all_.served < helpful_.served) ? all_ : helpful_;
    ++queue.served;
    const int number = queue.queue.top().second;
    queue.queue.pop();
    return number;
  }

  /// Children wait under their parent's estimate; their own is computed when their turn comes.
  void expand(int number, const State& state) {
    if (heuristic_.evaluations() >= max_evaluations_) {
      throw LimitReached{"no plan was found within " + std::to_string(max_evaluations_) + " evaluated states"};
    }
    const std::optional<Estimate> estimate = heuristic_.estimate(state);
    if (!estimate) return;
    if (estimate->length < best_) {
      constexpr std::int64_t kBoost = 1000;
      best_ = estimate->length;
      helpful_.served -= kBoost;
    }
    for (const int op : space_.applicable(state)) {
      const auto [child, is_new] = table_.insert(space_.successor(state, op));
      if (is_new) add_node({number, op});
      if (closed_[static_cast<std::size_t>(child)]) continue;
      const bool is_helpful = std::binary_search(estimate->helpful.begin(), estimate->helpful.end(), op);
      if (is_helpful) push(helpful_, estimate->length, child);
      if (is_new || is_helpful) push(all_, estimate->length, child);
    }
  }

  const StateSpace& space_;
  RelaxedPlanHeuristic& heuristic_;
  std::size_t max_evaluations_;
  StateTable table_;
  std::vector<Origin> origins_;  // by state
  std::vector<bool> closed_;     // by state
  Queue all_, helpful_;
  std::size_t pushed_ = 0;
  int best_ = INT32_MAX;
};

}  // namespace

std::optional<OperatorSequence> best_first(const StateSpace& space, RelaxedPlanHeuristic& heuristic,
                                           std::size_t max_evaluations) {
  return BestFirstSearch(space, heuristic, max_evaluations).search();
}

}  // namespace amiss::plan
