// A PDDL problem as read: objects, what is true at first, the goal and whether costs count.
//
// In: PDDL text and the Domain it names. Out: a Problem whose indices refer to that domain.
// Errors: InputError "file:line: what is wrong; what is allowed". Thesis 4.2.3.
#pragma once

#include "plan/domain.hpp"

namespace amiss::plan {

/// A predicate of objects, without variables; also (function, objects) where a cost is looked up.
struct GroundAtom {
  int symbol = 0;
  std::vector<int> objects;
  auto operator<=>(const GroundAtom&) const = default;
};

struct FunctionValue {
  GroundAtom term;
  double value = 0;
};

struct Problem {
  std::string name;
  std::vector<Object> objects;        // the domain's constants first
  std::vector<GroundAtom> init;       // sorted, each once
  std::vector<FunctionValue> values;  // sorted by term, each term once
  Formula goal;
  int goal_variable_count = 0;  // the most quantified variables bound at once
  bool minimize_cost = false;   // :metric minimize (total-cost); else plans are compared by length
};

[[nodiscard]] Problem load_problem(const std::filesystem::path& file, const Domain& domain);
/// `name` stands in error sentences where the file would.
[[nodiscard]] Problem parse_problem(std::string_view text, const Domain& domain, const std::string& name);

/// "(at truck-1 depot)"
[[nodiscard]] std::string to_string(const Domain& domain, const Problem& problem, const GroundAtom& atom);

}  // namespace amiss::plan
