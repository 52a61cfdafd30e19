#include "plan/internal/state_space.hpp"

#include <algorithm>
#include <bit>

namespace amiss::plan {
namespace {

std::size_t hash_words(const std::uint64_t* words, std::size_t count) {
  std::uint64_t hash = 0x9e3779b97f4a7c15U;
  for (std::size_t i = 0; i < count; ++i) {
    hash = (hash ^ words[i]) * 0xff51afd7ed558ccdU;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

}  // namespace

StateSpace::StateSpace(const Task& task) : task_(task), watchers_(task.fact_count) {
  for (std::size_t number = 0; number < task.operators.size(); ++number) {
    const std::vector<int>& facts = task.operators[number].precondition;
    const auto fewer_watchers = [this](int a, int b) {
      return watchers_[static_cast<std::size_t>(a)].size() < watchers_[static_cast<std::size_t>(b)].size();
    };
    const auto watched = std::min_element(facts.begin(), facts.end(), fewer_watchers);
    (watched == facts.end() ? always_ : watchers_[static_cast<std::size_t>(*watched)])
        .push_back(static_cast<int>(number));
  }
}

State StateSpace::initial() const {
  State state((task_.fact_count + 63) / 64, 0);
  for (const int fact : task_.init) state[static_cast<unsigned>(fact) / 64] |= std::uint64_t{1} << (fact % 64);
  return state;
}

bool StateSpace::all_hold(const State& state, const std::vector<int>& facts) {
  return std::all_of(facts.begin(), facts.end(), [&](int fact) { return holds(state, fact); });
}

bool StateSpace::is_applicable(const State& state, int number) const {
  return all_hold(state, op(number).precondition);
}

std::vector<int> StateSpace::applicable(const State& state) const {
  std::vector<int> operators = always_;
  for (std::size_t word = 0; word < state.size(); ++word) {
    for (std::uint64_t bits = state[word]; bits != 0; bits &= bits - 1) {
      for (const int number : watchers_[word * 64 + static_cast<std::size_t>(std::countr_zero(bits))]) {
        if (is_applicable(state, number)) operators.push_back(number);
      }
    }
  }
  std::sort(operators.begin(), operators.end());
  return operators;
}

void StateSpace::set(State& state, int fact, bool value) const {
  const auto assign = [&](int number, bool on) {
    const auto bit = static_cast<unsigned>(number);
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    state[bit / 64] = on ? state[bit / 64] | mask : state[bit / 64] & ~mask;
  };
  assign(fact, value);
  const int complement = task_.complement[static_cast<std::size_t>(fact)];
  if (complement != kNoComplement) assign(complement, !value);
}

State StateSpace::successor(const State& state, int number) const {
  State next = state;
  const std::vector<GroundEffect>& effects = op(number).effects;
  for (const GroundEffect& effect : effects) {
    if (effect.deletes.empty() || !all_hold(state, effect.condition)) continue;
    for (const int fact : effect.deletes) set(next, fact, false);
  }
  for (const GroundEffect& effect : effects) {
    if (!all_hold(state, effect.condition)) continue;
    for (const int fact : effect.adds) set(next, fact, true);
  }
  return next;
}

StateTable::Entry StateTable::insert(const State& state) {
  width_ = state.size();
  if (slots_.size() < 2 * (count_ + 1)) grow();
  std::size_t slot = hash_words(state.data(), width_) & (slots_.size() - 1);
  for (; slots_[slot] >= 0; slot = (slot + 1) & (slots_.size() - 1)) {
    if (std::equal(state.begin(), state.end(), words(static_cast<std::size_t>(slots_[slot])))) {
      return {slots_[slot], false};
    }
  }
  slots_[slot] = static_cast<int>(count_);
  pool_.insert(pool_.end(), state.begin(), state.end());
  return {static_cast<int>(count_++), true};
}

State StateTable::operator[](int number) const {
  const std::uint64_t* const first = words(static_cast<std::size_t>(number));
  return {first, first + width_};
}

void StateTable::grow() {
  constexpr std::size_t kFirstSlots = 64;
  slots_.assign(std::max(kFirstSlots, slots_.size() * 2), -1);
  for (std::size_t number = 0; number < count_; ++number) {
    std::size_t slot = hash_words(words(number), width_) & (slots_.size() - 1);
    while (slots_[slot] >= 0) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = static_cast<int>(number);
  }
}

}  // namespace amiss::plan
