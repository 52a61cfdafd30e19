// What can be reached when nothing is ever deleted.
#pragma once

#include "plan/internal/task.hpp"

namespace amiss::plan {

class Relaxation {
 public:
  /// The task must outlive it.
  explicit Relaxation(const Task& task);

  /// By fact: whether it can become true. A fact `barred` never does, not even where it holds at first.
  [[nodiscard]] std::vector<bool> reachable(const std::vector<int>& from, int barred = -1) const;
  /// Conditions looked at by one call of reachable(), about.
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::vector<std::vector<int>> adds_;               // by effect; complements of what it deletes included
  std::vector<std::size_t> needs_;                   // by effect
  std::vector<std::vector<std::size_t>> needed_by_;  // by fact
  std::size_t size_ = 0;
};

}  // namespace amiss::plan
