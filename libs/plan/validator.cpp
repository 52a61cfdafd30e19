#include "plan/validator.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace amiss::plan {
namespace {

using Kind = Formula::Kind;
using Values = std::vector<int>;  // of the variables bound so far

std::size_t index(int number) { return static_cast<std::size_t>(number); }

/// Why a formula is not as wanted: an atom and what it should be.
struct Miss {
  std::string literal;
};

class World {
 public:
  World(const Domain& domain, const Problem& problem)
      : domain_(domain), problem_(problem), facts_(problem.init.begin(), problem.init.end()) {}

  /// Absent: the formula is as wanted.
  [[nodiscard]] std::optional<Miss> miss(bool wanted, const Formula& formula, Values& values) const {
    switch (formula.kind) {
      case Kind::kNot:
        return miss(!wanted, formula.parts[0], values);
      case Kind::kAnd:
      case Kind::kOr:
        return parts_miss(wanted, (formula.kind == Kind::kAnd) == wanted, formula, values);
      case Kind::kForall:
      case Kind::kExists:
        return quantified_miss(wanted, (formula.kind == Kind::kForall) == wanted, formula, 0, values);
      case Kind::kAtom: {
        const GroundAtom atom = ground(formula.atom, values);
        if (facts_.contains(atom) == wanted) return std::nullopt;
        return Miss{signed_text(wanted, to_string(domain_, problem_, atom))};
      }
      case Kind::kEqual: {
        const int a = value(formula.atom.terms[0], values), b = value(formula.atom.terms[1], values);
        if ((a == b) == wanted) return std::nullopt;
        return Miss{signed_text(wanted, "(= " + object_name(a) + " " + object_name(b) + ")")};
      }
    }
    return std::nullopt;
  }

  /// All conditions are looked at before anything changes; then what is deleted goes, then what is added comes.
  void apply(const Action& action, Values& values) {
    std::vector<GroundAtom> adds, deletes;
    for (const Effect& effect : action.effects) collect(effect, 0, values, adds, deletes);
    for (const GroundAtom& atom : deletes) facts_.erase(atom);
    facts_.insert(adds.begin(), adds.end());
  }

  [[nodiscard]] std::optional<double> cost(const Action& action, const Values& values) const {
    double sum = 0;
    for (const CostTerm& term : action.costs) {
      sum += term.constant;
      if (!term.function) continue;
      const GroundAtom wanted = ground({*term.function, term.terms}, values);
      const auto found = std::find_if(problem_.values.begin(), problem_.values.end(),
                                      [&](const FunctionValue& entry) { return entry.term == wanted; });
      if (found == problem_.values.end()) return std::nullopt;
      sum += found->value;
    }
    return sum;
  }

 private:
  static int value(const Term& term, const Values& values) {
    return term.is_variable ? values[index(term.index)] : term.index;
  }
  [[nodiscard]] const std::string& object_name(int object) const { return problem_.objects[index(object)].name; }
  static std::string signed_text(bool positive, const std::string& atom) {
    return positive ? atom : "(not " + atom + ")";
  }

  static GroundAtom ground(const Atom& atom, const Values& values) {
    GroundAtom result{atom.predicate, {}};
    for (const Term& term : atom.terms) result.objects.push_back(value(term, values));
    return result;
  }

  [[nodiscard]] std::optional<Miss> parts_miss(bool wanted, bool all, const Formula& formula, Values& values) const {
    std::optional<Miss> last = all ? std::nullopt : std::optional<Miss>(Miss{"(or)"});
    for (const Formula& part : formula.parts) {
      std::optional<Miss> here = miss(wanted, part, values);
      if (here.has_value() == all) return here;
      last = std::move(here);
    }
    return last;
  }

  [[nodiscard]] std::optional<Miss> quantified_miss(bool wanted, bool all, const Formula& formula, std::size_t variable,
                                                    Values& values) const {
    if (variable == formula.variables.size()) return miss(wanted, formula.parts[0], values);
    std::optional<Miss> last = all ? std::nullopt : std::optional<Miss>(Miss{"(exists)"});
    for (std::size_t object = 0; object < problem_.objects.size(); ++object) {
      if (!accepts(domain_, formula.variables[variable], problem_.objects[object].type)) continue;
      values[index(formula.first_variable) + variable] = static_cast<int>(object);
      std::optional<Miss> here = quantified_miss(wanted, all, formula, variable + 1, values);
      if (here.has_value() == all) return here;
      last = std::move(here);
    }
    return last;
  }

  void collect(const Effect& effect, std::size_t variable, Values& values, std::vector<GroundAtom>& adds,
               std::vector<GroundAtom>& deletes) const {
    if (variable < effect.variables.size()) {
      for (std::size_t object = 0; object < problem_.objects.size(); ++object) {
        if (!accepts(domain_, effect.variables[variable], problem_.objects[object].type)) continue;
        values[index(effect.first_variable) + variable] = static_cast<int>(object);
        collect(effect, variable + 1, values, adds, deletes);
      }
      return;
    }
    if (miss(true, effect.condition, values)) return;
    for (const Literal& literal : effect.literals) {
      (literal.positive ? adds : deletes).push_back(ground(literal.atom, values));
    }
  }

  const Domain& domain_;
  const Problem& problem_;
  std::set<GroundAtom> facts_;
};

class Validator {
 public:
  Validator(const Domain& domain, const Problem& problem)
      : domain_(domain), problem_(problem), world_(domain, problem) {
    for (std::size_t i = 0; i < domain.actions.size(); ++i) actions_.emplace(domain.actions[i].name, i);
    for (std::size_t i = 0; i < problem.objects.size(); ++i) objects_.emplace(problem.objects[i].name, i);
  }

  Result<double, PlanFault> run(const Plan& plan) {
    double cost = 0;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
      const Result<double, PlanFault> step = take(i + 1, plan.steps[i]);
      if (!step) return step;
      cost += *step;
    }
    Values values(index(problem_.goal_variable_count), 0);
    if (const std::optional<Miss> miss = world_.miss(true, problem_.goal, values)) {
      return Answer::failure(
          {std::nullopt, miss->literal, "the goal is not met at the end: " + miss->literal + " is missing"});
    }
    return cost;
  }

 private:
  using Answer = Result<double, PlanFault>;

  static Answer fault(std::size_t number, const Step& step, const std::string& what, const std::string& literal = {}) {
    return Answer::failure({number, literal, "step " + std::to_string(number) + " " + to_string(step) + ": " + what});
  }

  Answer take(std::size_t number, const Step& step) {
    const auto found = actions_.find(step.action);
    if (found == actions_.end()) return fault(number, step, "the domain has no action '" + step.action + "'");
    const Action& action = domain_.actions[found->second];
    if (step.arguments.size() != action.parameters.size()) {
      return fault(number, step,
                   "the action takes " + std::to_string(action.parameters.size()) + " arguments, not " +
                       std::to_string(step.arguments.size()));
    }
    Values values(index(action.variable_count), 0);
    for (std::size_t i = 0; i < step.arguments.size(); ++i) {
      const auto object = objects_.find(step.arguments[i]);
      if (object == objects_.end()) return fault(number, step, "there is no object '" + step.arguments[i] + "'");
      if (!accepts(domain_, action.parameters[i], problem_.objects[object->second].type)) {
        return fault(number, step,
                     "the object '" + step.arguments[i] + "' is of the wrong type for " + action.parameters[i].name);
      }
      values[i] = static_cast<int>(object->second);
    }
    return perform(number, step, action, values);
  }

  Answer perform(std::size_t number, const Step& step, const Action& action, Values& values) {
    if (const std::optional<Miss> miss = world_.miss(true, action.precondition, values)) {
      return fault(number, step, "its precondition " + miss->literal + " does not hold", miss->literal);
    }
    const std::optional<double> cost = problem_.minimize_cost ? world_.cost(action, values) : 1.0;
    if (!cost) return fault(number, step, "the problem gives no value for its cost");
    world_.apply(action, values);
    return *cost;
  }

  const Domain& domain_;
  const Problem& problem_;
  World world_;
  std::unordered_map<std::string, std::size_t> actions_, objects_;
};

}  // namespace

Result<double, PlanFault> validate(const Domain& domain, const Problem& problem, const Plan& plan) {
  return Validator(domain, problem).run(plan);
}

}  // namespace amiss::plan
