#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

#include "plan/internal/landmarks.hpp"
#include "plan/internal/search.hpp"

namespace amiss::plan {
namespace {

class BestFirstSearch {
 public:
  BestFirstSearch(const StateSpace& space, RelaxedPlanHeuristic& heuristic, std::size_t max_evaluations)
      : space_(space), heuristic_(heuristic), max_evaluations_(max_evaluations), landmarks_(space) {}

  std::optional<OperatorSequence> search() {
    const State first = space_.initial();
    table_.insert(first);
    add_node({}, landmarks_.at_first(first));
    all_.queue.push({{0, 0, age_++}, 0});
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
  using Key = std::tuple<int, int, std::size_t>;  // landmarks left, length of the relaxed plan, age
  struct Queue {
    std::priority_queue<std::pair<Key, int>, std::vector<std::pair<Key, int>>, std::greater<>> queue;
    std::int64_t served = 0;
  };

  void add_node(Origin origin, Landmarks::Accepted accepted) {
    accepted_.push_back(std::move(accepted));
    origins_.push_back(origin);
    closed_.push_back(false);
  }

  int pop() {
    Queue& queue = helpful_.queue.empty() || (!all_.queue.empty() && all_.served < helpful_.served) ? all_ : helpful_;
    ++queue.served;
    const int number = queue.queue.top().second;
    queue.queue.pop();
    return number;
  }

  void note_progress(std::pair<int, int> estimate) {
    constexpr std::int64_t kBoost = 100;
    if (estimate >= best_) return;
    best_ = estimate;
    helpful_.served -= kBoost;
  }

  /// Children wait under their parent's estimate; their own is computed when their turn comes.
  void expand(int number, const State& state) {
    if (heuristic_.evaluations() >= max_evaluations_) {
      throw LimitReached{"no plan was found within " + std::to_string(max_evaluations_) + " evaluated states"};
    }
    const std::optional<Estimate> estimate = heuristic_.estimate(state);
    if (!estimate) return;
    const Landmarks::Accepted accepted = accepted_[static_cast<std::size_t>(number)];
    const int left = landmarks_.count_left(state, accepted);
    note_progress({left, estimate->length});
    for (const int op : space_.applicable(state)) {
      const State next = space_.successor(state, op);
      const auto [child, is_new] = table_.insert(next);
      if (is_new) {
        add_node({number, op}, accepted);
        landmarks_.accept(next, accepted_.back());
      }
      if (closed_[static_cast<std::size_t>(child)]) continue;
      const bool is_helpful = std::binary_search(estimate->helpful.begin(), estimate->helpful.end(), op);
      if (is_helpful) helpful_.queue.push({{left, estimate->length, age_++}, child});
      if (is_new || is_helpful) all_.queue.push({{left, estimate->length, age_++}, child});
    }
  }

  const StateSpace& space_;
  RelaxedPlanHeuristic& heuristic_;
  std::size_t max_evaluations_;
  Landmarks landmarks_;
  StateTable table_;
  std::vector<Origin> origins_;                // by state
  std::vector<bool> closed_;                   // by state
  std::vector<Landmarks::Accepted> accepted_;  // by state
  Queue all_, helpful_;
  std::size_t age_ = 0;
  std::pair<int, int> best_{INT32_MAX, INT32_MAX};
};

}  // namespace

std::optional<OperatorSequence> best_first(const StateSpace& space, RelaxedPlanHeuristic& heuristic,
                                           std::size_t max_evaluations) {
  return BestFirstSearch(space, heuristic, max_evaluations).search();
}

}  // namespace amiss::plan
