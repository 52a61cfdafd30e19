// Facts that every plan must make true at some time, and how many of them are still to come.
//
// A fact is a landmark when the goal is out of reach, even without deletes, for actions that do not need it and do not
// give it. (Zhu and Givan, ICAPS 2003; counting them: Richter and Westphal, The LAMA planner, JAIR 39, 2010.)
#pragma once

#include "plan/internal/state_space.hpp"

namespace amiss::plan {

class Landmarks {
 public:
  explicit Landmarks(const StateSpace& space);

  /// By landmark: whether it was true at some state on the way here.
  using Accepted = std::vector<bool>;
  [[nodiscard]] Accepted at_first(const State& state) const;
  void accept(const State& state, Accepted& accepted) const;
  /// Landmarks not accepted yet, and those accepted, false now and needed again: for the goal, or right before a
  /// landmark that is not accepted yet.
  [[nodiscard]] int count_left(const State& state, const Accepted& accepted) const;

 private:
  struct Landmark {
    int fact = 0;
    bool is_goal = false;
    std::vector<std::size_t> needed_right_before;  // landmarks whose first achievers all need this one
  };

  void find_immediate_needs(const StateSpace& space, std::size_t landmark, const std::vector<bool>& reachable_without);

  std::vector<Landmark> landmarks_;
};

}  // namespace amiss::plan
