#include "plan/internal/reachability.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>

namespace amiss::plan {
namespace {

using Kind = Formula::Kind;

std::size_t index(int number) { return static_cast<std::size_t>(number); }

/// An action with what the join needs to know of its precondition.
struct Pattern {
  const Action* action = nullptr;
  std::vector<const Atom*> atoms;          // atoms that must hold
  std::vector<bool> atom_is_fluent;        // beside them
  std::vector<const Formula*> equalities;  // (= a b) and (not (= a b)) that must hold
};

void collect(const Formula& formula, Pattern& pattern) {
  if (formula.kind == Kind::kAnd) {
    for (const Formula& part : formula.parts) collect(part, pattern);
  } else if (formula.kind == Kind::kAtom) {
    pattern.atoms.push_back(&formula.atom);
  } else if (formula.kind == Kind::kEqual || (formula.kind == Kind::kNot && formula.parts[0].kind == Kind::kEqual)) {
    pattern.equalities.push_back(&formula);
  }
}

class Explorer {
 public:
  Explorer(const Domain& domain, const Problem& problem, std::size_t max_instances)
      : domain_(domain),
        problem_(problem),
        max_instances_(max_instances),
        budget_(work_for(max_instances), kSentence),
        index_(domain.predicates),
        truth_(reach_, budget_) {
    sort_objects();
    mark_fluents();
    for (const Action& action : domain.actions) add_pattern(action);
  }

  Reachability explore() {
    for (const GroundAtom& atom : problem_.init) {
      const int number = reach_.atoms.add(atom);
      if (reach_.is_fluent[index(atom.symbol)]) {
        open_.push_back(number);
      } else {
        index_.add(number, atom);
      }
    }
    for (const Pattern& pattern : patterns_) start_without_fluents(pattern);
    while (!open_.empty()) {
      newest_ = open_.front();
      open_.pop_front();
      index_.add(newest_, reach_.atoms[newest_]);
      match_newest();
    }
    return std::move(reach_);
  }

 private:
  static constexpr const char* kSentence = "grounding the actions takes more steps than the limit allows";

  static std::size_t work_for(std::size_t instances) {
    constexpr std::size_t kStepsPerInstance = 50;
    return std::max<std::size_t>(instances, 100'000) * kStepsPerInstance;
  }

  void sort_objects() {
    reach_.objects_of_type.resize(domain_.types.size());
    for (std::size_t object = 0; object < problem_.objects.size(); ++object) {
      const std::vector<bool>& is_a = domain_.types[index(problem_.objects[object].type)].is_a;
      for (std::size_t type = 0; type < is_a.size(); ++type) {
        if (is_a[type]) reach_.objects_of_type[type].push_back(static_cast<int>(object));
      }
    }
  }

  void mark_fluents() {
    reach_.is_fluent.assign(domain_.predicates.size(), false);
    for (const Action& action : domain_.actions) {
      for (const Effect& effect : action.effects) {
        for (const Literal& literal : effect.literals) reach_.is_fluent[index(literal.atom.predicate)] = true;
      }
    }
  }

  void add_pattern(const Action& action) {
    Pattern pattern;
    pattern.action = &action;
    collect(action.precondition, pattern);
    for (const Atom* atom : pattern.atoms) pattern.atom_is_fluent.push_back(reach_.is_fluent[index(atom->predicate)]);
    patterns_.push_back(std::move(pattern));
  }

  void start_without_fluents(const Pattern& pattern) {
    if (std::count(pattern.atom_is_fluent.begin(), pattern.atom_is_fluent.end(), true) != 0) return;
    begin(pattern);
    join();
  }

  void match_newest() {
    const int predicate = reach_.atoms[newest_].symbol;
    for (const Pattern& pattern : patterns_) {
      for (std::size_t i = 0; i < pattern.atoms.size(); ++i) {
        if (pattern.atoms[i]->predicate != predicate) continue;
        begin(pattern);
        delta_ = i;
        done_[i] = true;
        with_match(*pattern.atoms[i], reach_.atoms[newest_].objects, [this] { join(); });
      }
    }
  }

  void begin(const Pattern& pattern) {
    pattern_ = &pattern;
    delta_ = pattern.atoms.size();
    done_.assign(pattern.atoms.size(), false);
    bindings_.assign(index(pattern.action->variable_count), kUnbound);
  }

  /// Binds the atom's variables to the objects, calls `then` if they fit, unbinds.
  void with_match(const Atom& atom, std::vector<int> objects, const std::function<void()>& then) {
    budget_.spend();
    std::vector<std::size_t> bound;
    bool fits = true;
    for (std::size_t i = 0; i < objects.size() && fits; ++i) {
      const Term& term = atom.terms[i];
      if (value_of(term, bindings_) == objects[i]) continue;
      fits = term.is_variable && bindings_[index(term.index)] == kUnbound && may_bind(term.index, objects[i]);
      if (!fits) break;
      bindings_[index(term.index)] = objects[i];
      bound.push_back(index(term.index));
    }
    if (fits && equalities_hold()) then();
    for (const std::size_t variable : bound) bindings_[variable] = kUnbound;
  }

  [[nodiscard]] bool may_bind(int variable, int object) const {
    return accepts(domain_, pattern_->action->parameters[index(variable)], problem_.objects[index(object)].type);
  }

  [[nodiscard]] bool equalities_hold() const {
    for (const Formula* formula : pattern_->equalities) {
      const bool wanted = formula->kind == Kind::kEqual;
      const std::vector<Term>& terms = (wanted ? *formula : formula->parts[0]).atom.terms;
      const int a = value_of(terms[0], bindings_), b = value_of(terms[1], bindings_);
      if (a != kUnbound && b != kUnbound && (a == b) != wanted) return false;
    }
    return true;
  }

  /// Fluents are indexed in the order of their numbers. An atom before the delta must be older than the newest one, so
  /// that no instance is found twice.
  [[nodiscard]] bool may_serve(std::size_t atom, int number) const {
    if (!pattern_->atom_is_fluent[atom]) return true;
    return atom < delta_ ? number < newest_ : number <= newest_;
  }

  void join() {
    const std::size_t mark = trail_.size();
    if (ground_atoms_hold()) branch();
    for (; trail_.size() > mark; trail_.pop_back()) done_[trail_.back()] = false;
  }

  /// Checks the atoms whose variables are all bound, and marks them as done.
  [[nodiscard]] bool ground_atoms_hold() {
    for (std::size_t i = 0; i < pattern_->atoms.size(); ++i) {
      const Atom& atom = *pattern_->atoms[i];
      const auto is_bound = [&](const Term& term) { return value_of(term, bindings_) != kUnbound; };
      if (done_[i] || !std::all_of(atom.terms.begin(), atom.terms.end(), is_bound)) continue;
      const std::optional<int> number = reach_.atoms.find(instantiate(atom, bindings_));
      if (!number || !may_serve(i, *number)) return false;
      done_[i] = true;
      trail_.push_back(i);
    }
    return true;
  }

  /// Goes on with the atom that has the fewest candidates.
  void branch() {
    std::size_t next = pattern_->atoms.size();
    const std::vector<int>* fewest = nullptr;
    for (std::size_t i = 0; i < pattern_->atoms.size(); ++i) {
      if (done_[i]) continue;
      const std::vector<int>& candidates = index_.candidates(*pattern_->atoms[i], bindings_);
      if (fewest != nullptr && candidates.size() >= fewest->size()) continue;
      fewest = &candidates;
      next = i;
    }
    if (fewest == nullptr) return bind_rest(0);
    done_[next] = true;
    // Nothing is indexed while a list is walked.
    for (const int number : *fewest) {
      if (!may_serve(next, number)) continue;
      with_match(*pattern_->atoms[next], reach_.atoms[number].objects, [this] { join(); });
    }
    done_[next] = false;
  }

  /// Parameters that no atom mentions may be any object of their type.
  void bind_rest(std::size_t parameter) {
    budget_.spend();
    const std::vector<Variable>& parameters = pattern_->action->parameters;
    while (parameter < parameters.size() && bindings_[parameter] != kUnbound) ++parameter;
    if (parameter == parameters.size()) return add_instance();
    for (const int object : objects_for(reach_, parameters[parameter])) {
      bindings_[parameter] = object;
      if (equalities_hold()) bind_rest(parameter + 1);
    }
    bindings_[parameter] = kUnbound;
  }

  void add_instance() {
    const Action& action = *pattern_->action;
    if (!truth_.may_be(true, action.precondition, bindings_)) return;
    if (reach_.instances.size() >= max_instances_)
      throw LimitReached{"there are more ground actions than the limit allows"};
    const auto parameters = static_cast<std::ptrdiff_t>(action.parameters.size());
    reach_.instances.push_back(
        {static_cast<int>(&action - domain_.actions.data()), {bindings_.begin(), bindings_.begin() + parameters}});
    for (const Effect& effect : action.effects) reach_effect(effect, 0);
  }

  void reach_effect(const Effect& effect, std::size_t variable) {
    budget_.spend();
    if (variable < effect.variables.size()) {
      int& value = bindings_[index(effect.first_variable) + variable];
      for (const int object : objects_for(reach_, effect.variables[variable])) {
        value = object;
        reach_effect(effect, variable + 1);
      }
      value = kUnbound;
      return;
    }
    if (!truth_.may_be(true, effect.condition, bindings_)) return;
    for (const Literal& literal : effect.literals) {
      if (!literal.positive) continue;
      budget_.spend();
      const std::size_t known = reach_.atoms.size();
      const int number = reach_.atoms.add(instantiate(literal.atom, bindings_));
      if (reach_.atoms.size() > known) open_.push_back(number);
    }
  }

  static constexpr int kUnbound = -1;

  const Domain& domain_;
  const Problem& problem_;
  std::size_t max_instances_;
  Budget budget_;
  Reachability reach_;
  AtomIndex index_;
  PossibleTruth truth_;
  std::vector<Pattern> patterns_;
  std::deque<int> open_;  // reachable, not yet indexed
  int newest_ = -1;

  // The join at work.
  const Pattern* pattern_ = nullptr;
  std::size_t delta_ = 0;
  std::vector<bool> done_;          // atoms of the precondition that are matched
  std::vector<std::size_t> trail_;  // those that were matched by checking, in this order
  Bindings bindings_;
};

}  // namespace

Reachability find_reachable(const Domain& domain, const Problem& problem, std::size_t max_instances) {
  return Explorer(domain, problem, max_instances).explore();
}

}  // namespace amiss::plan
