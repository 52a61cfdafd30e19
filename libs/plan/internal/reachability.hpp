// Which actions with which objects can ever be carried out, if nothing were ever deleted?
//
// Semi-naive evaluation, as for Datalog: every atom that becomes reachable is matched once against every precondition
// that it can serve, and the other preconditions of that action are joined with what is reachable already, the one
// with the fewest candidates first. Static atoms so prune at once. (Helmert, Concise finite-domain representations,
// AIJ 173, 2009, does the same with a logic program.)
#pragma once

#include "plan/internal/atom_table.hpp"
#include "plan/internal/budget.hpp"

namespace amiss::plan {

struct Instance {
  int action = 0;
  std::vector<int> arguments;
};

struct Reachability {
  std::vector<Instance> instances;
  AtomTable atoms;                                // all that are reachable, those of the initial state first
  std::vector<bool> is_fluent;                    // by predicate: some action changes it
  std::vector<std::vector<int>> objects_of_type;  // by type, its subtypes' objects included
};

/// Objects that may stand for a variable, in ascending order.
[[nodiscard]] std::vector<int> objects_for(const Reachability& reach, const Variable& variable);

/// Whether the formula may hold in some state: static predicates are decided by the initial state, fluents may be
/// either. Spends a step for each part looked at.
class PossibleTruth {
 public:
  PossibleTruth(const Reachability& reach, Budget& budget) : reach_(reach), budget_(budget) {}
  [[nodiscard]] bool may_be(bool wanted, const Formula& formula, Bindings& bindings) const;

 private:
  [[nodiscard]] bool quantified(bool wanted, const Formula& formula, std::size_t variable, Bindings& bindings) const;

  const Reachability& reach_;
  Budget& budget_;
};

/// Throws LimitReached when there are more instances than allowed.
[[nodiscard]] Reachability find_reachable(const Domain& domain, const Problem& problem, std::size_t max_instances);

}  // namespace amiss::plan
