// The grounded problem: facts are numbers, actions have objects in place of variables.
//
// Negative conditions are gone: where "not f" is asked for, a fact of its own, the complement, says so.
#pragma once

#include <vector>

namespace amiss::plan {

inline constexpr int kNoComplement = -1;

/// Sorted fact numbers. What is deleted and added at once is added; complements follow by themselves.
struct GroundEffect {
  std::vector<int> condition, adds, deletes;
};

struct Operator {
  int action = -1;  // index into the domain's actions; -1: only says that one way to meet the goal is met
  std::vector<int> arguments;
  double cost = 1;
  std::vector<int> precondition;
  std::vector<GroundEffect> effects;
};

struct Task {
  std::size_t fact_count = 0;
  std::vector<int> complement;  // by fact
  std::vector<int> init, goal;  // sorted
  std::vector<Operator> operators;
  bool goal_reachable = true;  // false: not even when nothing is ever deleted
};

}  // namespace amiss::plan
