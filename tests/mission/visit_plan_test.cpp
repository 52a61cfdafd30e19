#include "mission/visit_plan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "plan/problem.hpp"
#include "plan/validator.hpp"

namespace amiss::mission {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();
using Action = PlannedStep::Action;

const plan::Domain& domain() {
  static const plan::Domain search = plan::load_domain(AMISS_SOURCE_DIR "/share/pddl/search.pddl");
  return search;
}

/// Places on the floor, the first where the robot stands, and the straight ways between them.
struct Round {
  std::vector<Visit> visits;
  std::vector<double> lengths_m;
  std::size_t n = 0;

  explicit Round(const std::vector<Eigen::Vector2d>& places) : n(places.size()) {
    for (std::size_t i = 1; i < n; ++i) {
      const auto kind = i % 3 == 0 ? Visit::Kind::kExamine : Visit::Kind::kExplore;
      visits.push_back({kind, static_cast<int>(i), {places[i].x(), places[i].y(), 0.0}});
    }
    for (const Eigen::Vector2d& a : places) {
      for (const Eigen::Vector2d& b : places) lengths_m.push_back((a - b).norm());
    }
  }
  double& length(std::size_t a, std::size_t b) { return lengths_m[a * n + b]; }
  void cut_off(std::size_t place) {
    for (std::size_t i = 0; i < n; ++i) {
      if (i != place) length(place, i) = length(i, place) = kNoWay;
    }
  }
  [[nodiscard]] double along(const std::vector<std::size_t>& order) const {
    double sum = 0.0;
    std::size_t at = 0;
    for (const std::size_t to : order) {
      sum += lengths_m[at * n + to];
      at = to;
    }
    return sum;
  }
};

/// The places in the order in which the plan drives to them.
std::vector<std::size_t> order_of(const VisitPlan& plan, const Round& round) {
  std::vector<std::size_t> order;
  for (const PlannedStep& step : plan.steps) {
    if (step.action != Action::kGoto) continue;
    const auto visit = std::find(round.visits.begin(), round.visits.end(), step.visit);
    order.push_back(static_cast<std::size_t>(visit - round.visits.begin()) + 1);
  }
  return order;
}

bool is_valid(const VisitPlan& visit_plan) {
  const plan::Problem problem = plan::parse_problem(visit_plan.problem_pddl, domain(), "problem");
  return static_cast<bool>(plan::validate(domain(), problem, visit_plan.plan));
}

RC_GTEST_PROP(VisitPlan, IsValidAndVisitsAll, ()) {
  std::vector<Eigen::Vector2d> places;
  for (int i = *rc::gen::inRange(2, 14); i > 0; --i) {
    places.emplace_back(0.01 * *rc::gen::inRange(0, 1000), 0.01 * *rc::gen::inRange(0, 1000));
  }
  const Round round(places);
  const auto plan = plan_visits(domain(), round.visits, round.lengths_m);
  RC_ASSERT(static_cast<bool>(plan));
  RC_ASSERT(is_valid(*plan));
  auto order = order_of(*plan, round);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> all(round.visits.size());
  std::iota(all.begin(), all.end(), std::size_t{1});
  RC_ASSERT(order == all);
}

TEST(VisitPlan, WorksWhereItHasDrivenTo) {
  const Round round({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  const auto plan = plan_visits(domain(), round.visits, round.lengths_m);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->steps.size(), 6U);
  for (std::size_t i = 0; i < 6; i += 2) {
    EXPECT_EQ(plan->steps[i].action, Action::kGoto);
    const bool examine = plan->steps[i].visit.kind == Visit::Kind::kExamine;
    EXPECT_EQ(plan->steps[i + 1].action, examine ? Action::kExamine : Action::kExplore);
    EXPECT_EQ(plan->steps[i + 1].visit, plan->steps[i].visit);
  }
  EXPECT_NEAR(plan->plan.cost, 300.0, 1e-9) << "centimetres on the way";
}

TEST(VisitPlan, OrderIsTheShortestOfAll) {
  for (int variant = 0; variant < 20; ++variant) {
    std::vector<Eigen::Vector2d> places;
    for (int i = 0; i < 7; ++i) places.emplace_back((i * 37 + variant * 13) % 17, (i * 53 + variant * 29) % 19);
    const Round round(places);
    const auto plan = plan_visits(domain(), round.visits, round.lengths_m);
    ASSERT_TRUE(plan);
    std::vector<std::size_t> order{1, 2, 3, 4, 5, 6};
    double best = kNoWay;
    do {
      best = std::min(best, round.along(order));
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(round.along(order_of(*plan, round)), best, 1e-9) << "variant " << variant;
  }
}

TEST(VisitPlan, UnreachablePlacesAreLeftOut) {
  Round round({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  round.cut_off(2);
  const auto plan = plan_visits(domain(), round.visits, round.lengths_m);
  ASSERT_TRUE(plan);
  EXPECT_EQ(order_of(*plan, round), (std::vector<std::size_t>{1, 3}));
  EXPECT_TRUE(is_valid(*plan));
  EXPECT_EQ(plan->problem_pddl.find("view2"), std::string::npos);
}

TEST(VisitPlan, NoPlaceIsAReason) {
  Round round({{0, 0}, {1, 0}});
  round.cut_off(1);
  const auto none = plan_visits(domain(), round.visits, round.lengths_m);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.why(), "no place can be reached");
  EXPECT_FALSE(plan_visits(domain(), {}, std::vector<double>{0.0}));
}

}  // namespace
}  // namespace amiss::mission
