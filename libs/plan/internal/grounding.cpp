#include "plan/internal/grounding.hpp"

#include <algorithm>

#include "plan/internal/normal_form.hpp"

namespace amiss::plan {
namespace {

void sort_unique(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// What is added is not deleted.
void tidy(GroundEffect& effect) {
  sort_unique(effect.adds);
  sort_unique(effect.deletes);
  std::erase_if(effect.deletes,
                [&](int fact) { return std::binary_search(effect.adds.begin(), effect.adds.end(), fact); });
}

class Grounder {
 public:
  Grounder(const Domain& domain, const Problem& problem, std::size_t max_operators)
      : domain_(domain),
        problem_(problem),
        max_operators_(max_operators),
        budget_(std::max<std::size_t>(max_operators, 100'000) * 100,
                "conditions written as alternatives take more steps than the limit allows"),
        reach_(find_reachable(domain, problem, max_operators)),
        normal_form_(reach_, budget_),
        fact_of_literal_(2 * reach_.atoms.size(), -1) {}

  Task ground() {
    for (const Instance& instance : reach_.instances) add_operators(instance);
    add_goal();
    add_init();
    return std::move(task_);
  }

 private:
  int new_fact() {
    task_.complement.push_back(kNoComplement);
    return static_cast<int>(task_.fact_count++);
  }

  int fact(int literal) {
    int& known = fact_of_literal_[static_cast<std::size_t>(literal)];
    if (known >= 0) return known;
    if (literal % 2 == 0) return known = new_fact();
    const int positive = fact(literal - 1);
    known = new_fact();
    task_.complement[static_cast<std::size_t>(positive)] = known;
    task_.complement[static_cast<std::size_t>(known)] = positive;
    return known;
  }

  std::vector<int> facts(const Conjunction& literals) {
    std::vector<int> result;
    for (const int literal : literals) result.push_back(fact(literal));
    sort_unique(result);
    return result;
  }

  void add_operators(const Instance& instance) {
    const Action& action = domain_.actions[static_cast<std::size_t>(instance.action)];
    Bindings bindings = instance.arguments;
    bindings.resize(static_cast<std::size_t>(action.variable_count), -1);
    const std::optional<double> cost = problem_.minimize_cost ? cost_of(problem_, action, bindings) : 1.0;
    if (!cost) return;
    const Disjunction alternatives = normal_form_.of(true, action.precondition, bindings);
    if (alternatives.empty()) return;
    const std::vector<GroundEffect> effects = ground_effects(action, bindings);
    for (const Conjunction& alternative : alternatives) {
      add_operator({instance.action, instance.arguments, *cost, facts(alternative), effects});
    }
  }

  void add_operator(Operator op) {
    if (task_.operators.size() >= max_operators_) {
      throw LimitReached{"there are more ground actions than the limit allows"};
    }
    task_.operators.push_back(std::move(op));
  }

  std::vector<GroundEffect> ground_effects(const Action& action, Bindings& bindings) {
    std::vector<GroundEffect> effects(1);  // the first one is not conditional
    for (const Effect& effect : action.effects) ground_effect(effect, 0, bindings, effects);
    for (GroundEffect& effect : effects) tidy(effect);
    return effects;
  }

  void ground_effect(const Effect& effect, std::size_t variable, Bindings& bindings,
                     std::vector<GroundEffect>& effects) {
    if (variable < effect.variables.size()) {
      for (const int object : objects_for(reach_, effect.variables[variable])) {
        bindings[static_cast<std::size_t>(effect.first_variable) + variable] = object;
        ground_effect(effect, variable + 1, bindings, effects);
      }
      return;
    }
    for (const Conjunction& condition : normal_form_.of(true, effect.condition, bindings)) {
      if (condition.empty()) {
        ground_literals(effect, bindings, effects[0]);
      } else {
        effects.push_back({facts(condition), {}, {}});
        ground_literals(effect, bindings, effects.back());
      }
    }
  }

  void ground_literals(const Effect& effect, const Bindings& bindings, GroundEffect& result) {
    for (const Literal& literal : effect.literals) {
      budget_.spend();
      const std::optional<int> atom = reach_.atoms.find(instantiate(literal.atom, bindings));
      if (!atom) continue;  // only deleted: never true
      (literal.positive ? result.adds : result.deletes).push_back(fact(2 * *atom));
    }
  }

  void add_goal() {
    Bindings bindings(static_cast<std::size_t>(problem_.goal_variable_count), -1);
    const Disjunction alternatives = normal_form_.of(true, problem_.goal, bindings);
    task_.goal_reachable = !alternatives.empty();
    if (alternatives.size() == 1) task_.goal = facts(alternatives[0]);
    if (alternatives.size() <= 1) return;
    const int met = new_fact();
    task_.goal = {met};
    for (const Conjunction& alternative : alternatives) {
      add_operator({-1, {}, 0, facts(alternative), {GroundEffect{{}, {met}, {}}}});
    }
  }

  void add_init() {
    std::vector<bool> initially(reach_.atoms.size(), false);
    for (const GroundAtom& atom : problem_.init) initially[static_cast<std::size_t>(*reach_.atoms.find(atom))] = true;
    for (std::size_t literal = 0; literal < fact_of_literal_.size(); ++literal) {
      const bool holds = initially[literal / 2] == (literal % 2 == 0);
      if (fact_of_literal_[literal] >= 0 && holds) task_.init.push_back(fact_of_literal_[literal]);
    }
    sort_unique(task_.init);
  }

  const Domain& domain_;
  const Problem& problem_;
  std::size_t max_operators_;
  Budget budget_;
  Reachability reach_;
  NormalForm normal_form_;
  std::vector<int> fact_of_literal_;  // -1: not needed yet
  Task task_;
};

}  // namespace

std::optional<double> cost_of(const Problem& problem, const Action& action, const Bindings& bindings) {
  double sum = 0;
  for (const CostTerm& term : action.costs) {
    sum += term.constant;
    if (!term.function) continue;
    const GroundAtom wanted = instantiate({*term.function, term.terms}, bindings);
    const auto found = std::lower_bound(problem.values.begin(), problem.values.end(), wanted,
                                        [](const FunctionValue& a, const GroundAtom& b) { return a.term < b; });
    if (found == problem.values.end() || found->term != wanted) return std::nullopt;
    sum += found->value;
  }
  return sum;
}

Task ground(const Domain& domain, const Problem& problem, std::size_t max_operators) {
  return simplify(Grounder(domain, problem, max_operators).ground());
}

}  // namespace amiss::plan
