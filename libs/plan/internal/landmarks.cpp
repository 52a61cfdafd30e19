#include "plan/internal/landmarks.hpp"

#include <algorithm>

#include "plan/internal/relaxation.hpp"

namespace amiss::plan {

Landmarks::Landmarks(const StateSpace& space) {
  const Task& task = space.task();
  constexpr std::size_t kMostWork = 100'000'000;  // facts times conditions; beyond, goals alone are counted
  const Relaxation relaxation(task);
  std::vector<std::vector<bool>> reachable_without;
  for (int fact = 0; fact < static_cast<int>(task.fact_count); ++fact) {
    const bool is_goal = std::binary_search(task.goal.begin(), task.goal.end(), fact);
    if (task.fact_count * relaxation.size() > kMostWork && !is_goal) continue;
    std::vector<bool> reachable = relaxation.reachable(task.init, fact);
    const auto is_reachable = [&](int goal) { return reachable[static_cast<std::size_t>(goal)]; };
    if (std::all_of(task.goal.begin(), task.goal.end(), is_reachable)) continue;
    landmarks_.push_back({fact, is_goal, {}});
    reachable_without.push_back(std::move(reachable));
  }
  for (std::size_t i = 0; i < landmarks_.size(); ++i) find_immediate_needs(space, i, reachable_without[i]);
}

void Landmarks::find_immediate_needs(const StateSpace& space, std::size_t landmark,
                                     const std::vector<bool>& reachable_without) {
  const auto reachable = [&](int fact) { return reachable_without[static_cast<std::size_t>(fact)]; };
  std::vector<std::size_t> needed(landmarks_.size(), 0);  // by how many of the first achievers
  std::size_t achievers = 0;
  for (const Operator& op : space.task().operators) {
    const auto adds = [&](const GroundEffect& effect) {
      return std::binary_search(effect.adds.begin(), effect.adds.end(), landmarks_[landmark].fact);
    };
    if (std::none_of(op.effects.begin(), op.effects.end(), adds)) continue;
    if (!std::all_of(op.precondition.begin(), op.precondition.end(), reachable)) continue;
    ++achievers;
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      needed[i] += std::binary_search(op.precondition.begin(), op.precondition.end(), landmarks_[i].fact) ? 1U : 0U;
    }
  }
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    if (i != landmark && achievers > 0 && needed[i] == achievers) landmarks_[i].needed_right_before.push_back(landmark);
  }
}

Landmarks::Accepted Landmarks::at_first(const State& state) const {
  Accepted accepted(landmarks_.size(), false);
  accept(state, accepted);
  return accepted;
}

void Landmarks::accept(const State& state, Accepted& accepted) const {
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    if (holds(state, landmarks_[i].fact)) accepted[i] = true;
  }
}

int Landmarks::count_left(const State& state, const Accepted& accepted) const {
  int count = 0;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const Landmark& landmark = landmarks_[i];
    const auto waits = [&](std::size_t later) { return !accepted[later]; };
    const auto is_needed_again = [&] {
      return landmark.is_goal ||
             std::any_of(landmark.needed_right_before.begin(), landmark.needed_right_before.end(), waits);
    };
    if (!accepted[i] || (!holds(state, landmark.fact) && is_needed_again())) ++count;
  }
  return count;
}

}  // namespace amiss::plan
