// Formulas over objects as a disjunction of conjunctions of literals.
#pragma once

#include "plan/internal/reachability.hpp"

namespace amiss::plan {

/// Literals 2 * atom (it is true) and 2 * atom + 1 (it is false); sorted, each once, without contradictions.
using Conjunction = std::vector<int>;
/// Any one of them; none: false.
using Disjunction = std::vector<Conjunction>;

class NormalForm {
 public:
  NormalForm(const Reachability& reach, Budget& budget) : reach_(reach), budget_(budget) {}

  [[nodiscard]] Disjunction of(bool wanted, const Formula& formula, Bindings& bindings) const;

 private:
  [[nodiscard]] Disjunction atom(bool wanted, const Atom& atom, const Bindings& bindings) const;
  void quantified(bool wanted, const Formula& formula, std::size_t variable, Bindings& bindings, bool all,
                  Disjunction& result) const;
  void join(bool all, Disjunction next, Disjunction& result) const;

  const Reachability& reach_;
  Budget& budget_;
};

}  // namespace amiss::plan
