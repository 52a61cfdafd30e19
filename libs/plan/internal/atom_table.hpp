// Numbers for ground atoms, and where to find those that may match an atom with variables.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "plan/problem.hpp"

namespace amiss::plan {

struct GroundAtomHash {
  std::size_t operator()(const GroundAtom& atom) const;
};

/// Atom <-> number, in the order of adding.
class AtomTable {
 public:
  int add(const GroundAtom& atom);
  [[nodiscard]] std::optional<int> find(const GroundAtom& atom) const;
  [[nodiscard]] const GroundAtom& operator[](int number) const { return atoms_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] std::size_t size() const { return atoms_.size(); }

 private:
  std::vector<GroundAtom> atoms_;
  std::unordered_map<GroundAtom, int, GroundAtomHash> numbers_;
};

/// Values of variables, -1 where none is bound yet.
using Bindings = std::vector<int>;

[[nodiscard]] inline int value_of(const Term& term, const Bindings& bindings) {
  return term.is_variable ? bindings[static_cast<std::size_t>(term.index)] : term.index;
}

/// The atom with all variables replaced; they must be bound.
[[nodiscard]] GroundAtom instantiate(const Atom& atom, const Bindings& bindings);

/// Lists of atom numbers by predicate and by (predicate, position, object), each in the order of adding.
class AtomIndex {
 public:
  explicit AtomIndex(const std::vector<Signature>& predicates);

  void add(int number, const GroundAtom& atom);
  /// The shortest list that holds every indexed atom that can match under the bindings.
  [[nodiscard]] const std::vector<int>& candidates(const Atom& atom, const Bindings& bindings) const;

 private:
  [[nodiscard]] std::uint64_t key(int predicate, std::size_t position, int object) const;

  std::vector<std::vector<int>> by_predicate_;
  std::vector<std::uint64_t> first_slot_;  // by predicate: its positions have numbers from here
  std::unordered_map<std::uint64_t, std::vector<int>> by_argument_;
  std::vector<int> none_;
};

}  // namespace amiss::plan
