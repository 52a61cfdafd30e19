#include "motion/internal/sampling_planner.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/InformedStateSampler.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <mutex>

#include "motion/internal/way_cost.hpp"
#include "motion/path.hpp"

namespace ob = ompl::base;

namespace amiss::motion::internal {
namespace {

constexpr double kRange_m = 2.0;       // longest edge of the tree
constexpr double kNearGuide_m = 0.25;  // standard deviation of the samples round the guide
constexpr double kGuided = 0.6;        // share of the samples
constexpr int kTries = 4;              // for a sample that is passable

Eigen::Vector2d point_of(const ob::State* state) {
  const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

void put(const Eigen::Vector2d& point, ob::State* state) {
  double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  values[0] = point.x();
  values[1] = point.y();
}

class LineValidator : public ob::MotionValidator {
 public:
  LineValidator(const ob::SpaceInformationPtr& space, const DriveMap& map) : ob::MotionValidator(space), map_(map) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return straight_passable(map_, point_of(a), point_of(b));
  }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last_valid) const override {
    last_valid.second = 0.0;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, a);
    return checkMotion(a, b);
  }

 private:
  const DriveMap& map_;
};

/// A part of the samples lies near the guide, the others where a shorter way could still lead.
class GuidedSampler : public ob::InformedSampler {
 public:
  GuidedSampler(const ob::ProblemDefinitionPtr& problem, unsigned tries, const DriveMap& map,
                const std::vector<Eigen::Vector2d>& guide, RandomStream& random, ob::InformedSamplerPtr others)
      : ob::InformedSampler(problem, tries), map_(map), guide_(guide), random_(random), others_(std::move(others)) {}

  bool sampleUniform(ob::State* state, const ob::Cost& most) override {
    for (int i = 0; i < kTries; ++i) {
      if (random_.uniform() < kGuided) {
        put(near_guide(), state);
      } else if (!others_->sampleUniform(state, most)) {
        continue;
      }
      const Cell c = map_.grid().cell_at(point_of(state));
      if (map_.grid().contains(c) && map_.passable(c)) return true;
    }
    return false;
  }
  bool sampleUniform(ob::State* state, const ob::Cost&, const ob::Cost& most) override {
    return sampleUniform(state, most);
  }
  [[nodiscard]] bool hasInformedMeasure() const override { return others_->hasInformedMeasure(); }
  [[nodiscard]] double getInformedMeasure(const ob::Cost& cost) const override {
    return others_->getInformedMeasure(cost);
  }

 private:
  Eigen::Vector2d near_guide() {
    const std::size_t leg = 1 + random_.below(guide_.size() - 1);
    const Eigen::Vector2d on = guide_[leg - 1] + random_.uniform() * (guide_[leg] - guide_[leg - 1]);
    const double dx = random_.normal(), dy = random_.normal();
    return on + kNearGuide_m * Eigen::Vector2d(dx, dy);
  }

  const DriveMap& map_;
  const std::vector<Eigen::Vector2d>& guide_;
  RandomStream& random_;
  ob::InformedSamplerPtr others_;
};

/// Length weighted by clearance. It is never less than the length, so the ellipse of the length holds all better ways.
class ClearanceObjective : public ob::PathLengthOptimizationObjective {
 public:
  ClearanceObjective(const ob::SpaceInformationPtr& space, const DriveMap& map, const SamplingTask& task,
                     RandomStream& random)
      : ob::PathLengthOptimizationObjective(space), map_(map), task_(task), random_(random) {}

  ob::Cost motionCost(const ob::State* a, const ob::State* b) const override {
    return ob::Cost(line_cost_m(map_, point_of(a), point_of(b), task_.clearance_weight));
  }
  ob::InformedSamplerPtr allocInformedStateSampler(const ob::ProblemDefinitionPtr& problem,
                                                   unsigned tries) const override {
    auto others = ob::PathLengthOptimizationObjective::allocInformedStateSampler(problem, tries);
    return std::make_shared<GuidedSampler>(problem, tries, map_, task_.guide, random_, std::move(others));
  }

 private:
  const DriveMap& map_;
  const SamplingTask& task_;
  RandomStream& random_;
};

ob::SpaceInformationPtr space_of(const DriveMap& map) {
  const FloorGrid& grid = map.grid();
  auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  const Eigen::Vector2d high = grid.origin_m() + grid.resolution_m() * Eigen::Vector2d(grid.width(), grid.height());
  for (unsigned axis = 0; axis < 2; ++axis) {
    bounds.setLow(axis, grid.origin_m()[axis]);
    bounds.setHigh(axis, high[axis]);
  }
  plane->setBounds(bounds);
  auto space = std::make_shared<ob::SpaceInformation>(plane);
  space->setStateValidityChecker([&map](const ob::State* state) {
    const Cell c = map.grid().cell_at(point_of(state));
    return map.grid().contains(c) && map.passable(c);
  });
  space->setMotionValidator(std::make_shared<LineValidator>(space, map));
  space->setup();
  return space;
}

}  // namespace

std::optional<std::vector<Eigen::Vector2d>> sample_way(const DriveMap& map, const SamplingTask& task,
                                                       RandomStream& random) {
  // OMPL takes the seeds of its generators from one that all threads share.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(random.next() >> 33U) | 1U);

  const ob::SpaceInformationPtr space = space_of(map);
  auto problem = std::make_shared<ob::ProblemDefinition>(space);
  ob::ScopedState<ob::RealVectorStateSpace> start(space), goal(space);
  put(task.guide.front(), start.get());
  put(task.guide.back(), goal.get());
  problem->setStartAndGoalStates(start, goal);
  problem->setOptimizationObjective(std::make_shared<ClearanceObjective>(space, map, task, random));

  ompl::geometric::InformedRRTstar planner(space);
  planner.setProblemDefinition(problem);
  planner.setRange(kRange_m);
  planner.setup();
  ob::IterationTerminationCondition enough(static_cast<unsigned>(task.iterations));
  planner.solve(enough);
  if (!problem->hasExactSolution()) return std::nullopt;
  std::vector<Eigen::Vector2d> way;
  for (const ob::State* state : problem->getSolutionPath()->as<ompl::geometric::PathGeometric>()->getStates()) {
    way.push_back(point_of(state));
  }
  return way;
}

}  // namespace amiss::motion::internal
