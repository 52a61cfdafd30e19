#include <algorithm>

#include "plan/internal/grounding.hpp"
#include "plan/internal/relaxation.hpp"

namespace amiss::plan {
namespace {

class Simplifier {
 public:
  explicit Simplifier(Task task)
      : task_(std::move(task)),
        reachable_(Relaxation(task_).reachable(task_.init)),
        constant_(task_.fact_count, false),
        relevant_(task_.fact_count, false) {}

  Task simplify() {
    const auto is_reachable = [this](int fact) { return has(reachable_, fact); };
    task_.goal_reachable = task_.goal_reachable && std::all_of(task_.goal.begin(), task_.goal.end(), is_reachable);
    if (!task_.goal_reachable) return unsolvable();
    drop_unreachable();
    mark_constant();
    drop_constant();
    mark_relevant();
    drop_irrelevant();
    renumber();
    return std::move(task_);
  }

 private:
  static bool has(const std::vector<bool>& set, int fact) { return set[static_cast<std::size_t>(fact)]; }
  [[nodiscard]] int complement(int fact) const { return task_.complement[static_cast<std::size_t>(fact)]; }

  bool mark(std::vector<bool>& set, int fact) {
    if (fact == kNoComplement || has(set, fact)) return false;
    set[static_cast<std::size_t>(fact)] = true;
    return true;
  }

  static Task unsolvable() {
    Task task;
    task.goal_reachable = false;
    return task;
  }

  void drop_unreachable() {
    const auto never = [this](const std::vector<int>& facts) {
      return std::any_of(facts.begin(), facts.end(), [this](int fact) { return !has(reachable_, fact); });
    };
    std::erase_if(task_.operators, [&](const Operator& op) { return never(op.precondition); });
    for (Operator& op : task_.operators) {
      std::erase_if(op.effects, [&](const GroundEffect& effect) { return never(effect.condition); });
      for (GroundEffect& effect : op.effects) {
        std::erase_if(effect.deletes, [this](int fact) { return !has(reachable_, fact); });
      }
    }
  }

  /// True at first and never deleted; of a complement: its partner is never added.
  void mark_constant() {
    std::vector<bool> changes(task_.fact_count, false);
    for (const Operator& op : task_.operators) {
      for (const GroundEffect& effect : op.effects) {
        for (const int fact : effect.deletes) mark(changes, fact);
        for (const int fact : effect.adds) mark(changes, complement(fact));
      }
    }
    for (const int fact : task_.init) {
      if (!has(changes, fact)) mark(constant_, fact);
    }
  }

  void drop_constant() {
    const auto is_constant = [this](int fact) { return has(constant_, fact); };
    std::erase_if(task_.goal, is_constant);
    for (Operator& op : task_.operators) {
      std::erase_if(op.precondition, is_constant);
      for (GroundEffect& effect : op.effects) {
        std::erase_if(effect.condition, is_constant);
        std::erase_if(effect.adds, is_constant);
      }
    }
  }

  [[nodiscard]] bool is_relevant(int fact) const { return fact != kNoComplement && has(relevant_, fact); }
  [[nodiscard]] bool adds_relevant(const GroundEffect& effect) const {
    return std::any_of(effect.adds.begin(), effect.adds.end(), [this](int fact) { return is_relevant(fact); }) ||
           std::any_of(effect.deletes.begin(), effect.deletes.end(),
                       [this](int fact) { return is_relevant(complement(fact)); });
  }
  [[nodiscard]] bool touches_relevant(const GroundEffect& effect) const {
    return adds_relevant(effect) ||
           std::any_of(effect.deletes.begin(), effect.deletes.end(), [this](int fact) { return is_relevant(fact); });
  }

  bool mark_all(const std::vector<int>& facts) {
    bool changed = false;
    for (const int fact : facts) {
      changed = mark(relevant_, fact) || changed;
      changed = mark(relevant_, complement(fact)) || changed;  // the two are kept together
    }
    return changed;
  }

  /// Backwards from the goal: what is needed by an operator that adds something needed.
  void mark_relevant() {
    mark_all(task_.goal);
    for (bool changed = true; changed;) {
      changed = false;
      for (const Operator& op : task_.operators) {
        if (std::none_of(op.effects.begin(), op.effects.end(), [this](const auto& e) { return adds_relevant(e); })) {
          continue;
        }
        changed = mark_all(op.precondition) || changed;
        for (const GroundEffect& effect : op.effects) {
          if (touches_relevant(effect)) changed = mark_all(effect.condition) || changed;
        }
      }
    }
  }

  void drop_irrelevant() {
    const auto is_irrelevant = [this](int fact) { return !has(relevant_, fact); };
    std::erase_if(task_.operators, [this](const Operator& op) {
      return std::none_of(op.effects.begin(), op.effects.end(), [this](const auto& e) { return adds_relevant(e); });
    });
    for (Operator& op : task_.operators) {
      for (GroundEffect& effect : op.effects) {
        std::erase_if(effect.adds, is_irrelevant);
        std::erase_if(effect.deletes, is_irrelevant);
      }
      std::erase_if(op.effects, [](const auto& effect) { return effect.adds.empty() && effect.deletes.empty(); });
    }
    std::erase_if(task_.init, is_irrelevant);
  }

  void renumber() {
    std::vector<int> number(task_.fact_count, kNoComplement);
    std::vector<int> complements;
    int next = 0;
    for (std::size_t fact = 0; fact < task_.fact_count; ++fact) {
      if (!relevant_[fact]) continue;
      number[fact] = next++;
      complements.push_back(task_.complement[fact]);
    }
    const auto translate = [&](std::vector<int>& facts) {
      for (int& fact : facts) fact = fact == kNoComplement ? fact : number[static_cast<std::size_t>(fact)];
    };
    translate(complements);
    translate(task_.init);
    translate(task_.goal);
    for (Operator& op : task_.operators) {
      translate(op.precondition);
      for (GroundEffect& effect : op.effects) {
        translate(effect.condition);
        translate(effect.adds);
        translate(effect.deletes);
      }
    }
    task_.complement = std::move(complements);
    task_.fact_count = static_cast<std::size_t>(next);
  }

  Task task_;
  std::vector<bool> reachable_, constant_, relevant_;
};

}  // namespace

Task simplify(Task task) { return Simplifier(std::move(task)).simplify(); }

}  // namespace amiss::plan
