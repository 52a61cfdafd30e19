// Lists -> formulas, effects and costs with variables and names resolved.
//
// Errors: InputError on unknown names, wrong numbers of arguments and operators that are not supported.
#pragma once

#include "plan/internal/vocabulary.hpp"

namespace amiss::plan {

class FormulaReader {
 public:
  FormulaReader(const Domain& domain, const Vocabulary& vocabulary, const Source& source)
      : domain_(domain), vocabulary_(vocabulary), source_(source) {}

  /// Binds the variables of a list while in scope, e.g. the parameters of an action.
  void push(const std::vector<Variable>& variables, const Sexpr& at);
  void pop(std::size_t count);
  [[nodiscard]] int most_variables() const { return static_cast<int>(most_bound_); }

  [[nodiscard]] Formula formula(const Sexpr& expression);
  /// Effects and costs of an action's :effect list.
  void effects(const Sexpr& expression, Action& action);

 private:
  [[nodiscard]] Formula connective(const Sexpr& expression, Formula::Kind kind);
  [[nodiscard]] Formula negation(const Sexpr& expression);
  [[nodiscard]] Formula implication(const Sexpr& expression);
  [[nodiscard]] Formula quantified(const Sexpr& expression, Formula::Kind kind);
  [[nodiscard]] Formula equality(const Sexpr& expression);
  [[nodiscard]] Atom atom(const Sexpr& expression);
  [[nodiscard]] Term term(const Sexpr& word);
  [[nodiscard]] std::vector<Term> terms(const Sexpr& expression, const Signature& signature);
  void effect(const Sexpr& expression, Effect& group, Action& action);
  void forall_effect(const Sexpr& expression, const Effect& group, Action& action);
  void when_effect(const Sexpr& expression, const Effect& group, Action& action);
  void increase(const Sexpr& expression, const Effect& group, Action& action);
  void need_size(const Sexpr& expression, std::size_t size, const std::string& form) const;

  const Domain& domain_;
  const Vocabulary& vocabulary_;
  const Source& source_;
  std::vector<Variable> bound_;
  std::size_t most_bound_ = 0;
};

/// A finite number that is not negative, or an InputError.
[[nodiscard]] double read_cost(const Sexpr& word, const Source& source);

}  // namespace amiss::plan
