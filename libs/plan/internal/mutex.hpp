// Pairs of facts that can never hold together, as far as looking at pairs shows: h^2 without costs.
//
// Haslum and Geffner, Admissible heuristics for optimal planning, AIPS 2000. Over-approximates what is reachable, so a
// pair that is told to be impossible is. Proves some problems unsolvable that look solvable when nothing is deleted.
#pragma once

#include <cstdint>

#include "plan/internal/task.hpp"

namespace amiss::plan {

class ReachablePairs {
 public:
  /// `steps` bounds the work; where that does not suffice, all pairs count as possible.
  ReachablePairs(const Task& task, std::size_t steps);

  [[nodiscard]] bool possible(const std::vector<int>& facts) const;

 private:
  struct Action {
    std::vector<int> needs, adds, deletes;  // deletes: those that happen for certain
  };

  [[nodiscard]] static std::vector<Action> actions_of(const Task& task);
  [[nodiscard]] bool has(int a, int b) const;
  bool mark(int a, int b);
  [[nodiscard]] bool possible_with(int fact, const std::vector<int>& facts) const;
  bool apply(const Action& action);

  std::size_t facts_;
  std::vector<bool> pairs_;  // facts x facts, symmetric
};

}  // namespace amiss::plan
