// Counts steps of work and stops it where a limit is reached: bounded like a clock, but the same on every machine.
#pragma once

#include <cstddef>
#include <string>

namespace amiss::plan {

/// Caught by solve(), which reports NoPlan::Reason::kLimitReached.
struct LimitReached {
  std::string sentence;
};

class Budget {
 public:
  Budget(std::size_t steps, std::string sentence) : left_(steps), sentence_(std::move(sentence)) {}

  void spend(std::size_t steps = 1) {
    if (steps > left_) throw LimitReached{sentence_};
    left_ -= steps;
  }

 private:
  std::size_t left_;
  std::string sentence_;
};

}  // namespace amiss::plan
