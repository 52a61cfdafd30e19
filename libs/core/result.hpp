// Three ways to fail: expected (Result), bad input (InputError, ArgumentError), own bug (assert).
#pragma once

#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace amiss {

/// An input that cannot be read or does not hold what it should: one sentence that names file, line or key, what is
/// wrong and what is allowed. The program ends with status 3.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Wrong arguments or parameters: the program ends with status 2.
struct ArgumentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A value, or the reason why there is none, where failing is an expected outcome.
template <class T, class E = std::string>
class Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  static Result failure(E why) { return Result(std::in_place_index<1>, std::move(why)); }

  [[nodiscard]] explicit operator bool() const { return state_.index() == 0; }
  [[nodiscard]] const T& operator*() const {
    assert(*this);
    return std::get<0>(state_);
  }
  [[nodiscard]] T& operator*() {
    assert(*this);
    return std::get<0>(state_);
  }
  [[nodiscard]] const T* operator->() const { return &**this; }
  [[nodiscard]] T* operator->() { return &**this; }
  [[nodiscard]] const E& why() const {
    assert(!*this);
    return std::get<1>(state_);
  }

 private:
  Result(std::in_place_index_t<1> tag, E why) : state_(tag, std::move(why)) {}
  std::variant<T, E> state_;
};

}  // namespace amiss
