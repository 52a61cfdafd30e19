#include "plan/internal/formula_reader.hpp"

#include <charconv>
#include <cmath>

namespace amiss::plan {

using Kind = Formula::Kind;

namespace {

bool is_conditional(const Effect& effect) { return !effect.condition.parts.empty(); }

}  // namespace

void FormulaReader::push(const std::vector<Variable>& variables, const Sexpr& at) {
  constexpr std::size_t kMostVariables = 100;
  if (bound_.size() + variables.size() > kMostVariables) {
    source_.fail(at, "more than " + std::to_string(kMostVariables) + " variables at once, which is the most allowed");
  }
  bound_.insert(bound_.end(), variables.begin(), variables.end());
  most_bound_ = std::max(most_bound_, bound_.size());
}

void FormulaReader::pop(std::size_t count) { bound_.resize(bound_.size() - count); }

void FormulaReader::need_size(const Sexpr& expression, std::size_t size, const std::string& form) const {
  if (expression.items.size() != size) source_.fail(expression, "'" + describe(expression) + "' should be " + form);
}

Formula FormulaReader::formula(const Sexpr& expression) {
  if (!expression.is_list)
    source_.fail(expression, "expected a condition in brackets, not '" + describe(expression) + "'");
  if (expression.items.empty()) return {};
  const std::string_view head = expression.head();
  if (head == "and") return connective(expression, Kind::kAnd);
  if (head == "or") return connective(expression, Kind::kOr);
  if (head == "not") return negation(expression);
  if (head == "imply") return implication(expression);
  if (head == "forall") return quantified(expression, Kind::kForall);
  if (head == "exists") return quantified(expression, Kind::kExists);
  if (head == "=") return equality(expression);
  if (head == "<" || head == ">" || head == "<=" || head == ">=") {
    source_.fail(expression, "comparing numbers is not supported; numbers are allowed as costs only");
  }
  if (head == "preference") source_.fail(expression, "preferences are not supported; every goal is a must");
  Formula result;
  result.kind = Kind::kAtom;
  result.atom = atom(expression);
  return result;
}

Formula FormulaReader::connective(const Sexpr& expression, Kind kind) {
  Formula result;
  result.kind = kind;
  for (std::size_t i = 1; i < expression.items.size(); ++i) result.parts.push_back(formula(expression.items[i]));
  return result;
}

Formula FormulaReader::negation(const Sexpr& expression) {
  need_size(expression, 2, "(not condition)");
  Formula result;
  result.kind = Kind::kNot;
  result.parts.push_back(formula(expression.items[1]));
  return result;
}

Formula FormulaReader::implication(const Sexpr& expression) {
  need_size(expression, 3, "(imply condition condition)");
  Formula not_first;
  not_first.kind = Kind::kNot;
  not_first.parts.push_back(formula(expression.items[1]));
  Formula result;
  result.kind = Kind::kOr;
  result.parts.push_back(std::move(not_first));
  result.parts.push_back(formula(expression.items[2]));
  return result;
}

Formula FormulaReader::quantified(const Sexpr& expression, Kind kind) {
  need_size(expression, 3, "(" + std::string(expression.head()) + " (?variable ...) condition)");
  if (!expression.items[1].is_list) source_.fail(expression, "expected the variables in brackets");
  Formula result;
  result.kind = kind;
  result.variables = read_variables(expression.items[1], 0, vocabulary_, source_);
  result.first_variable = static_cast<int>(bound_.size());
  push(result.variables, expression);
  result.parts.push_back(formula(expression.items[2]));
  pop(result.variables.size());
  return result;
}

Formula FormulaReader::equality(const Sexpr& expression) {
  need_size(expression, 3, "(= object object)");
  Formula result;
  result.kind = Kind::kEqual;
  result.atom.terms = {term(expression.items[1]), term(expression.items[2])};
  return result;
}

Atom FormulaReader::atom(const Sexpr& expression) {
  if (!expression.is_list || expression.items.empty()) {
    source_.fail(expression, "expected (predicate object ...), not '" + describe(expression) + "'");
  }
  const int predicate = vocabulary_.predicates.at(expression.items[0], source_);
  return {predicate, terms(expression, domain_.predicates[static_cast<std::size_t>(predicate)])};
}

std::vector<Term> FormulaReader::terms(const Sexpr& expression, const Signature& signature) {
  const std::size_t wanted = signature.parameters.size();
  if (expression.items.size() != wanted + 1) {
    source_.fail(expression, "'" + describe(expression) + "' has " + std::to_string(expression.items.size() - 1) +
                                 " arguments; '" + signature.name + "' takes " + std::to_string(wanted));
  }
  std::vector<Term> result;
  for (std::size_t i = 1; i < expression.items.size(); ++i) result.push_back(term(expression.items[i]));
  return result;
}

Term FormulaReader::term(const Sexpr& word) {
  const std::string& name = source_.word(word, "a variable or an object");
  if (name[0] != '?') return {false, vocabulary_.objects.at(word, source_)};
  for (std::size_t i = bound_.size(); i-- > 0;) {
    if (bound_[i].name == name) return {true, static_cast<int>(i)};
  }
  source_.fail(word, "the variable '" + describe(word) + "' is not bound; it must be a parameter or quantified");
}

void FormulaReader::effects(const Sexpr& expression, Action& action) {
  if (!expression.is_list) source_.fail(expression, "expected an effect in brackets");
  if (expression.items.empty()) return;
  Effect always;
  always.first_variable = static_cast<int>(bound_.size());
  effect(expression, always, action);
  if (!always.literals.empty()) action.effects.push_back(std::move(always));
}

void FormulaReader::effect(const Sexpr& expression, Effect& group, Action& action) {
  if (!expression.is_list || expression.items.empty()) {
    source_.fail(expression, "expected an effect in brackets, not '" + describe(expression) + "'");
  }
  const std::string_view head = expression.head();
  if (head == "and") {
    for (std::size_t i = 1; i < expression.items.size(); ++i) effect(expression.items[i], group, action);
  } else if (head == "forall") {
    forall_effect(expression, group, action);
  } else if (head == "when") {
    when_effect(expression, group, action);
  } else if (head == "increase") {
    increase(expression, group, action);
  } else if (head == "assign" || head == "decrease" || head == "scale-up" || head == "scale-down") {
    source_.fail(expression, "'" + std::string(head) + "' is not supported; (increase (total-cost) ...) is allowed");
  } else {
    const bool positive = head != "not";
    if (!positive) need_size(expression, 2, "(not (predicate ...))");
    group.literals.push_back({atom(positive ? expression : expression.items[1]), positive});
  }
}

void FormulaReader::forall_effect(const Sexpr& expression, const Effect& group, Action& action) {
  need_size(expression, 3, "(forall (?variable ...) effect)");
  if (is_conditional(group)) source_.fail(expression, "forall inside of when is not allowed; when inside of forall is");
  if (!expression.items[1].is_list) source_.fail(expression, "expected the variables in brackets");
  const std::vector<Variable> variables = read_variables(expression.items[1], 0, vocabulary_, source_);
  Effect inner;
  inner.variables = group.variables;
  inner.first_variable = group.first_variable;
  inner.variables.insert(inner.variables.end(), variables.begin(), variables.end());
  push(variables, expression);
  effect(expression.items[2], inner, action);
  pop(variables.size());
  if (!inner.literals.empty()) action.effects.push_back(std::move(inner));
}

void FormulaReader::when_effect(const Sexpr& expression, const Effect& group, Action& action) {
  need_size(expression, 3, "(when condition effect)");
  if (is_conditional(group)) source_.fail(expression, "when inside of when is not allowed; (and ...) joins conditions");
  Effect inner;
  inner.variables = group.variables;
  inner.first_variable = group.first_variable;
  inner.condition.parts.push_back(formula(expression.items[1]));
  effect(expression.items[2], inner, action);
  if (!inner.literals.empty()) action.effects.push_back(std::move(inner));
}

void FormulaReader::increase(const Sexpr& expression, const Effect& group, Action& action) {
  need_size(expression, 3, "(increase (total-cost) amount)");
  if (expression.items[1].head() != "total-cost" || expression.items[1].items.size() != 1 || !domain_.has_total_cost) {
    source_.fail(expression, "only (total-cost) may be increased, and it must be declared in :functions");
  }
  if (!group.variables.empty() || is_conditional(group)) {
    source_.fail(expression,
                 "a cost inside of forall or when is not supported; an action's cost must not depend on the state");
  }
  const Sexpr& amount = expression.items[2];
  CostTerm cost;
  if (!amount.is_list) {
    cost.constant = read_cost(amount, source_);
  } else if (!amount.items.empty()) {
    cost.function = vocabulary_.functions.at(amount.items[0], source_);
    cost.terms = terms(amount, domain_.functions[static_cast<std::size_t>(*cost.function)]);
  } else {
    source_.fail(amount, "expected a number or (function object ...)");
  }
  action.costs.push_back(std::move(cost));
}

double read_cost(const Sexpr& word, const Source& source) {
  const std::string& text = source.word(word, "a number");
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) {
    source.fail(word, "'" + describe(word) + "' is no number");
  }
  constexpr double kLargest = 1e9;
  if (value < 0 || value > kLargest) source.fail(word, "the cost " + text + " is out of range; allowed are 0 to 1e9");
  return value;
}

}  // namespace amiss::plan
