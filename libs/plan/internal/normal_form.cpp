#include "plan/internal/normal_form.hpp"

#include <algorithm>

namespace amiss::plan {
namespace {

using Kind = Formula::Kind;

/// Appends more literals; false when that makes a contradiction.
bool merge(Conjunction& into, const Conjunction& more) {
  const auto middle = static_cast<std::ptrdiff_t>(into.size());
  into.insert(into.end(), more.begin(), more.end());
  std::inplace_merge(into.begin(), into.begin() + middle, into.end());
  into.erase(std::unique(into.begin(), into.end()), into.end());
  const auto contradicts = [](int a, int b) { return a % 2 == 0 && b == a + 1; };
  return std::adjacent_find(into.begin(), into.end(), contradicts) == into.end();
}

}  // namespace

Disjunction NormalForm::of(bool wanted, const Formula& formula, Bindings& bindings) const {
  budget_.spend();
  switch (formula.kind) {
    case Kind::kNot:
      return of(!wanted, formula.parts[0], bindings);
    case Kind::kAtom:
      return atom(wanted, formula.atom, bindings);
    case Kind::kEqual: {
      const std::vector<Term>& terms = formula.atom.terms;
      const bool same = value_of(terms[0], bindings) == value_of(terms[1], bindings);
      return same == wanted ? Disjunction{{}} : Disjunction{};
    }
    case Kind::kAnd:
    case Kind::kOr: {
      const bool all = (formula.kind == Kind::kAnd) == wanted;
      Disjunction result = all ? Disjunction{{}} : Disjunction{};
      for (const Formula& part : formula.parts) join(all, of(wanted, part, bindings), result);
      return result;
    }
    case Kind::kForall:
    case Kind::kExists: {
      const bool all = (formula.kind == Kind::kForall) == wanted;
      Disjunction result = all ? Disjunction{{}} : Disjunction{};
      quantified(wanted, formula, 0, bindings, all, result);
      return result;
    }
  }
  return {};
}

Disjunction NormalForm::atom(bool wanted, const Atom& atom, const Bindings& bindings) const {
  const std::optional<int> number = reach_.atoms.find(instantiate(atom, bindings));
  const bool is_fluent = reach_.is_fluent[static_cast<std::size_t>(atom.predicate)];
  if (number && is_fluent) return {{2 * *number + (wanted ? 0 : 1)}};
  return number.has_value() == wanted ? Disjunction{{}} : Disjunction{};
}

void NormalForm::quantified(bool wanted, const Formula& formula, std::size_t variable, Bindings& bindings, bool all,
                            Disjunction& result) const {
  if (variable == formula.variables.size()) return join(all, of(wanted, formula.parts[0], bindings), result);
  for (const int object : objects_for(reach_, formula.variables[variable])) {
    bindings[static_cast<std::size_t>(formula.first_variable) + variable] = object;
    quantified(wanted, formula, variable + 1, bindings, all, result);
  }
}

void NormalForm::join(bool all, Disjunction next, Disjunction& result) const {
  if (!all) {
    result.insert(result.end(), std::make_move_iterator(next.begin()), std::make_move_iterator(next.end()));
    return;
  }
  if (next.size() == 1 && next[0].empty()) return;
  Disjunction product;
  for (const Conjunction& left : result) {
    for (const Conjunction& right : next) {
      budget_.spend(1 + left.size() + right.size());
      Conjunction both = left;
      if (merge(both, right)) product.push_back(std::move(both));
    }
  }
  result = std::move(product);
}

}  // namespace amiss::plan
