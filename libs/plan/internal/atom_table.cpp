#include "plan/internal/atom_table.hpp"

namespace amiss::plan {

std::size_t GroundAtomHash::operator()(const GroundAtom& atom) const {
  std::uint64_t hash = static_cast<std::uint64_t>(atom.symbol) + 0x9e3779b97f4a7c15U;
  for (const int object : atom.objects) {
    hash = (hash ^ static_cast<std::uint64_t>(object)) * 0xff51afd7ed558ccdU;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

int AtomTable::add(const GroundAtom& atom) {
  const auto [where, is_new] = numbers_.emplace(atom, static_cast<int>(atoms_.size()));
  if (is_new) atoms_.push_back(atom);
  return where->second;
}

std::optional<int> AtomTable::find(const GroundAtom& atom) const {
  const auto found = numbers_.find(atom);
  if (found == numbers_.end()) return std::nullopt;
  return found->second;
}

GroundAtom instantiate(const Atom& atom, const Bindings& bindings) {
  GroundAtom result{atom.predicate, {}};
  result.objects.reserve(atom.terms.size());
  for (const Term& term : atom.terms) result.objects.push_back(value_of(term, bindings));
  return result;
}

AtomIndex::AtomIndex(const std::vector<Signature>& predicates) : by_predicate_(predicates.size()) {
  std::uint64_t slots = 0;
  for (const Signature& predicate : predicates) {
    first_slot_.push_back(slots);
    slots += predicate.parameters.size();
  }
}

std::uint64_t AtomIndex::key(int predicate, std::size_t position, int object) const {
  constexpr unsigned kObjectBits = 32;
  return (first_slot_[static_cast<std::size_t>(predicate)] + position) << kObjectBits |
         static_cast<std::uint64_t>(object);
}

void AtomIndex::add(int number, const GroundAtom& atom) {
  by_predicate_[static_cast<std::size_t>(atom.symbol)].push_back(number);
  for (std::size_t i = 0; i < atom.objects.size(); ++i) {
    by_argument_[key(atom.symbol, i, atom.objects[i])].push_back(number);
  }
}

const std::vector<int>& AtomIndex::candidates(const Atom& atom, const Bindings& bindings) const {
  const std::vector<int>* best = &by_predicate_[static_cast<std::size_t>(atom.predicate)];
  for (std::size_t i = 0; i < atom.terms.size(); ++i) {
    const int object = value_of(atom.terms[i], bindings);
    if (object < 0) continue;
    const auto found = by_argument_.find(key(atom.predicate, i, object));
    if (found == by_argument_.end()) return none_;
    if (found->second.size() < best->size()) best = &found->second;
  }
  return *best;
}

}  // namespace amiss::plan
