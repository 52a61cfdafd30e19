// A PDDL domain as read: types, constants, predicates, functions of costs and actions with formulas over variables.
//
// In: PDDL text with :strips :typing :negative-preconditions :equality :conditional-effects :disjunctive-preconditions,
// quantified preconditions (so :adl) and :action-costs. Out: a Domain; every index in it is valid.
// Errors: InputError "file:line: what is wrong; what is allowed". Names are lower case, as PDDL does not mind case.
// Thesis 4.2.3; PDDL 2.1 (Fox and Long 2003), costs from the language of IPC 2008.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace amiss::plan {

/// A parameter or quantified variable; its value is an object of any one of `types`.
struct Variable {
  std::string name;
  std::vector<int> types;
};

/// Variable: an index into the values bound so far (parameters first, then quantified ones from the outside in).
/// Otherwise an index into the objects, of which the domain's constants are the first.
struct Term {
  bool is_variable = false;
  int index = 0;
};

struct Atom {
  int predicate = 0;  // meaningless in Formula::Kind::kEqual
  std::vector<Term> terms;
};

/// An empty kAnd is true, an empty kOr is false. kNot, kForall and kExists have one part.
struct Formula {
  enum class Kind { kAnd, kOr, kNot, kAtom, kEqual, kForall, kExists };
  Kind kind = Kind::kAnd;
  Atom atom;                        // kAtom; kEqual compares its two terms
  std::vector<Formula> parts;       // kAnd, kOr, kNot, kForall, kExists
  std::vector<Variable> variables;  // kForall, kExists
  int first_variable = 0;           // index of variables[0] among the values bound
};

struct Literal {
  Atom atom;
  bool positive = true;
};

/// For all values of `variables` for which `condition` holds before the action, the literals become true. What one
/// effect of an action makes false and another makes true is true afterwards.
struct Effect {
  std::vector<Variable> variables;
  int first_variable = 0;
  Formula condition;
  std::vector<Literal> literals;
};

/// One summand of an action's cost: a number, or the value of a function of objects.
struct CostTerm {
  double constant = 0;
  std::optional<int> function;
  std::vector<Term> terms;
};

struct Action {
  std::string name;
  std::vector<Variable> parameters;
  Formula precondition;
  std::vector<Effect> effects;
  std::vector<CostTerm> costs;
  int variable_count = 0;  // parameters and the most quantified variables bound at once
};

struct Type {
  std::string name;
  std::vector<int> parents;
  std::vector<bool> is_a;  // by type: this one or one of its ancestors
};

/// A predicate, or a function whose value is a number.
struct Signature {
  std::string name;
  std::vector<Variable> parameters;
};

struct Object {
  std::string name;
  int type = 0;
};

struct Domain {
  std::string name;
  std::vector<Type> types;  // [0] is "object", ancestor of all
  std::vector<Object> constants;
  std::vector<Signature> predicates;
  std::vector<Signature> functions;  // without total-cost
  bool has_total_cost = false;
  std::vector<Action> actions;
};

/// Whether an object of this type may stand for the variable.
[[nodiscard]] bool accepts(const Domain& domain, const Variable& variable, int type);

[[nodiscard]] Domain load_domain(const std::filesystem::path& file);
/// `name` stands in error sentences where the file would.
[[nodiscard]] Domain parse_domain(std::string_view text, const std::string& name);

}  // namespace amiss::plan
