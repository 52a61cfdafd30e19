// States as sets of facts, what can be done in them, and tables of states met.
#pragma once

#include <cstdint>

#include "plan/internal/task.hpp"

namespace amiss::plan {

/// One bit for a fact.
using State = std::vector<std::uint64_t>;

[[nodiscard]] inline bool holds(const State& state, int fact) {
  const auto bit = static_cast<unsigned>(fact);
  return (state[bit / 64] >> (bit % 64) & 1U) != 0;
}

class StateSpace {
 public:
  explicit StateSpace(const Task& task);

  [[nodiscard]] const Task& task() const { return task_; }
  [[nodiscard]] const Operator& op(int number) const { return task_.operators[static_cast<std::size_t>(number)]; }
  [[nodiscard]] State initial() const;
  [[nodiscard]] bool is_goal(const State& state) const { return all_hold(state, task_.goal); }
  [[nodiscard]] bool is_applicable(const State& state, int op) const;
  /// Ascending.
  [[nodiscard]] std::vector<int> applicable(const State& state) const;
  [[nodiscard]] State successor(const State& state, int op) const;

 private:
  [[nodiscard]] static bool all_hold(const State& state, const std::vector<int>& facts);
  void set(State& state, int fact, bool value) const;

  const Task& task_;
  std::vector<std::vector<int>> watchers_;  // by fact: operators to look at where it holds
  std::vector<int> always_;                 // operators without precondition
};

/// Numbers states in the order of meeting them.
class StateTable {
 public:
  struct Entry {
    int number;
    bool is_new;
  };
  Entry insert(const State& state);
  [[nodiscard]] State operator[](int number) const;
  [[nodiscard]] std::size_t size() const { return count_; }

 private:
  [[nodiscard]] const std::uint64_t* words(std::size_t number) const { return pool_.data() + number * width_; }
  void grow();

  std::size_t width_ = 0;  // words in a state
  std::size_t count_ = 0;
  std::vector<std::uint64_t> pool_;
  std::vector<int> slots_;  // open addressing; -1 is free
};

}  // namespace amiss::plan
