#include "plan/planner.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <map>
#include <set>

#include "plan/validator.hpp"

namespace amiss::plan {
namespace {

using State = std::set<int>;

/// A small propositional STRIPS problem, simple enough for breadth-first search over sets.
struct Strips {
  struct Action {
    State needs, forbids, adds, deletes;
  };
  std::vector<Action> actions;
  State init, goal;
};

std::string fact(int number) { return "(f" + std::to_string(number) + ")"; }

std::string literals(const State& positive, const State& negative) {
  std::string text = "(and";
  for (const int f : positive) text += " " + fact(f);
  for (const int f : negative) text += " (not " + fact(f) + ")";
  return text + ")";
}

constexpr int kFacts = 6;

std::string domain_text(const Strips& strips) {
  std::string text = "(define (domain d) (:requirements :strips :negative-preconditions) (:predicates";
  for (int f = 0; f < kFacts; ++f) text += " " + fact(f);
  text += ")";
  for (std::size_t i = 0; i < strips.actions.size(); ++i) {
    const Strips::Action& action = strips.actions[i];
    text += " (:action a" + std::to_string(i) + " :precondition " + literals(action.needs, action.forbids) +
            " :effect " + literals(action.adds, action.deletes) + ")";
  }
  return text + ")";
}

std::string problem_text(const Strips& strips) {
  std::string init;
  for (const int f : strips.init) init += " " + fact(f);
  return "(define (problem p) (:domain d) (:init" + init + ") (:goal " + literals(strips.goal, {}) + "))";
}

bool includes(const State& state, const State& part) {
  return std::includes(state.begin(), state.end(), part.begin(), part.end());
}

/// The length of the shortest plan, by breadth-first search: slow and obvious.
std::optional<std::size_t> shortest(const Strips& strips) {
  std::map<State, std::size_t> depth = {{strips.init, 0}};
  std::deque<State> open = {strips.init};
  for (; !open.empty(); open.pop_front()) {
    const State state = open.front();
    if (includes(state, strips.goal)) return depth[state];
    for (const Strips::Action& action : strips.actions) {
      const auto holds = [&](int f) { return state.contains(f); };
      if (!includes(state, action.needs) || std::any_of(action.forbids.begin(), action.forbids.end(), holds)) continue;
      State next = state;
      for (const int f : action.deletes) next.erase(f);
      next.insert(action.adds.begin(), action.adds.end());
      if (depth.emplace(next, depth[state] + 1).second) open.push_back(next);
    }
  }
  return std::nullopt;
}

State some_facts(std::size_t most) {
  const auto facts =
      *rc::gen::container<std::vector<int>>(*rc::gen::inRange<std::size_t>(0, most + 1), rc::gen::inRange(0, kFacts));
  return {facts.begin(), facts.end()};
}

Strips some_problem() {
  Strips strips{{}, some_facts(2), some_facts(3)};
  const int count = *rc::gen::inRange(1, 8);
  for (int i = 0; i < count; ++i) {
    strips.actions.push_back({some_facts(2), some_facts(1), some_facts(2), some_facts(2)});
  }
  return strips;
}

RC_GTEST_PROP(Planner, FindsAPlanExactlyWhereBreadthFirstSearchDoes, ()) {
  const Strips strips = some_problem();
  const Domain domain = parse_domain(domain_text(strips), "domain");
  const Problem problem = parse_problem(problem_text(strips), domain, "problem");
  const auto solution = solve(domain, problem);
  const std::optional<std::size_t> best = shortest(strips);
  RC_ASSERT(static_cast<bool>(solution) == best.has_value());
  if (!solution) {
    RC_ASSERT(solution.why().reason == NoPlan::Reason::kUnsolvable);
    return;
  }
  RC_ASSERT(solution->plan.steps.size() == *best);  // so small that the improvement sees every state
  RC_ASSERT(static_cast<bool>(validate(domain, problem, solution->plan)));
}

Result<Solution, NoPlan> solve_text(const std::string& domain_text, const std::string& problem_text,
                                    const Limits& limits = {}) {
  const Domain domain = parse_domain(domain_text, "domain");
  const Problem problem = parse_problem(problem_text, domain, "problem");
  auto solution = solve(domain, problem, limits);
  if (solution) {
    const auto cost = validate(domain, problem, solution->plan);
    EXPECT_TRUE(cost) << cost.why().sentence;
    EXPECT_DOUBLE_EQ(*cost, solution->plan.cost);
  }
  return solution;
}

TEST(Planner, MindsConditionalEffects) {
  const auto solution = solve_text(
      "(define (domain d) (:predicates (lit ?l) (on)) (:constants a b)"
      " (:action toggle :effect (and (when (on) (not (on))) (when (not (on)) (on))))"
      " (:action flash :precondition (on) :effect (forall (?l) (when (not (lit ?l)) (lit ?l)))))",
      "(define (problem p) (:domain d) (:init) (:goal (and (lit a) (lit b) (not (on)))))");
  ASSERT_TRUE(solution);
  EXPECT_EQ(to_string(solution->plan), "(toggle)\n(flash)\n(toggle)\n; cost = 3\n");
}

TEST(Planner, MindsDisjunctionsAndQuantifiers) {
  const auto solution = solve_text(
      "(define (domain d) (:requirements :adl) (:types t) (:predicates (p ?x - t) (q ?x - t) (done))"
      " (:action mark :parameters (?x - t) :precondition (or (p ?x) (exists (?y - t) (and (q ?y) (not (= ?x ?y)))))"
      " :effect (q ?x)) (:action end :precondition (forall (?x - t) (imply (p ?x) (q ?x))) :effect (done)))",
      "(define (problem p) (:domain d) (:objects a b c - t) (:init (p a) (p b)) (:goal (or (and (done) (q c)) (p "
      "c))))");
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->plan.steps.size(), 4U);
}

TEST(Planner, WhatIsDeletedAndAddedAtOnceIsTrue) {
  const auto solution =
      solve_text("(define (domain d) (:predicates (p) (q)) (:action a :effect (and (not (p)) (p) (q))))",
                 "(define (problem p) (:domain d) (:init (p)) (:goal (and (p) (q))))");
  EXPECT_TRUE(solution);
}

constexpr const char* kRoads =
    "(define (domain roads) (:requirements :typing :action-costs) (:types place) (:predicates (at ?p - place)"
    " (road ?a ?b - place)) (:functions (total-cost) - number (length ?a ?b - place) - number)"
    " (:action drive :parameters (?a ?b - place) :precondition (and (at ?a) (road ?a ?b))"
    " :effect (and (not (at ?a)) (at ?b) (increase (total-cost) (length ?a ?b)))))";

std::string road_problem(const std::string& metric) {
  return "(define (problem p) (:domain roads) (:objects a b c - place) (:init (at a) (road a b) (road b c) (road a c)"
         " (= (length a b) 2) (= (length b c) 3) (= (length a c) 9)) (:goal (at c)) " +
         metric + ")";
}

TEST(Planner, GoesByCostWhereTheProblemAsksForIt) {
  const auto cheap = solve_text(kRoads, road_problem("(:metric minimize (total-cost))"));
  ASSERT_TRUE(cheap);
  EXPECT_EQ(cheap->plan.cost, 5);
  const auto brief = solve_text(kRoads, road_problem(""));
  ASSERT_TRUE(brief);
  EXPECT_EQ(brief->plan.cost, 1);
}

TEST(Planner, ToldApartUnsolvableAndLimit) {
  const auto out_of_reach = solve_text(kRoads,
                                       "(define (problem p) (:domain roads) (:objects a b - place)"
                                       " (:init (at a)) (:goal (at b)))");
  ASSERT_FALSE(out_of_reach);
  EXPECT_EQ(out_of_reach.why().reason, NoPlan::Reason::kUnsolvable);
  const auto both_at_once = solve_text(kRoads,
                                       "(define (problem p) (:domain roads) (:objects a b - place)"
                                       " (:init (at a) (road a b) (road b a)) (:goal (and (at a) (at b))))");
  ASSERT_FALSE(both_at_once);
  EXPECT_EQ(both_at_once.why().reason, NoPlan::Reason::kUnsolvable);
  const auto stopped = solve_text(kRoads, road_problem(""), {.max_ground_actions = 1});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.why().reason, NoPlan::Reason::kLimitReached);
}

TEST(Planner, EmptyGoalNeedsNoStep) {
  const auto solution = solve_text(kRoads, "(define (problem p) (:domain roads) (:init) (:goal (and)))");
  ASSERT_TRUE(solution);
  EXPECT_TRUE(solution->plan.steps.empty());
}

}  // namespace
}  // namespace amiss::plan
