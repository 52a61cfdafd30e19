#include <algorithm>

#include "plan/internal/reachability.hpp"

namespace amiss::plan {
namespace {

using Kind = Formula::Kind;

std::size_t index(int number) { return static_cast<std::size_t>(number); }

}  // namespace

std::vector<int> objects_for(const Reachability& reach, const Variable& variable) {
  std::vector<int> objects = reach.objects_of_type[index(variable.types[0])];
  for (std::size_t i = 1; i < variable.types.size(); ++i) {
    const std::vector<int>& more = reach.objects_of_type[index(variable.types[i])];
    objects.insert(objects.end(), more.begin(), more.end());
  }
  if (variable.types.size() > 1) {
    std::sort(objects.begin(), objects.end());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  }
  return objects;
}

bool PossibleTruth::may_be(bool wanted, const Formula& formula, Bindings& bindings) const {
  budget_.spend();
  const auto part_may_be = [&](const Formula& part) { return may_be(wanted, part, bindings); };
  switch (formula.kind) {
    case Kind::kNot:
      return may_be(!wanted, formula.parts[0], bindings);
    case Kind::kAnd:
    case Kind::kOr:
      return (formula.kind == Kind::kAnd) == wanted
                 ? std::all_of(formula.parts.begin(), formula.parts.end(), part_may_be)
                 : std::any_of(formula.parts.begin(), formula.parts.end(), part_may_be);
    case Kind::kAtom:
      if (reach_.is_fluent[index(formula.atom.predicate)]) return true;
      return reach_.atoms.find(instantiate(formula.atom, bindings)).has_value() == wanted;
    case Kind::kEqual:
      return (value_of(formula.atom.terms[0], bindings) == value_of(formula.atom.terms[1], bindings)) == wanted;
    case Kind::kForall:
    case Kind::kExists:
      return quantified(wanted, formula, 0, bindings);
  }
  return false;
}

bool PossibleTruth::quantified(bool wanted, const Formula& formula, std::size_t variable, Bindings& bindings) const {
  if (variable == formula.variables.size()) return may_be(wanted, formula.parts[0], bindings);
  const bool all = (formula.kind == Kind::kForall) == wanted;
  for (const int object : objects_for(reach_, formula.variables[variable])) {
    bindings[index(formula.first_variable) + variable] = object;
    if (quantified(wanted, formula, variable + 1, bindings) != all) return !all;
  }
  return all;
}

}  // namespace amiss::plan
