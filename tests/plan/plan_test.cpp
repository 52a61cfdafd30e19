#include "plan/plan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/result.hpp"
#include "plan/problem_text.hpp"
#include "plan/validator.hpp"

namespace amiss::plan {
namespace {

TEST(Plan, ReadsTheUsualWaysOfWritingOne) {
  const Plan plan = parse_plan(
      "; found\n(GoTo hsr WP1 wp2)\r\n\n0.000: (look hsr) [1.000]\n  12 : ( look  hsr )  ; again\n", "x.plan");
  ASSERT_EQ(plan.steps.size(), 3U);
  EXPECT_EQ(plan.steps[0], (Step{"goto", {"hsr", "wp1", "wp2"}}));
  EXPECT_EQ(plan.steps[1], plan.steps[2]);
}

TEST(Plan, ErrorsNameTheLine) {
  for (const std::string text : {"(a)\n(b", "(a)\nb c", "(a)\n(b (c))", "(a)\nx: (b)", "(a)\n()", "(a)\n(b) 3"}) {
    try {
      (void)parse_plan(text, "x.plan");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("x.plan:2: ")) << error.what();
    }
  }
}

RC_GTEST_PROP(Plan, TextIsReadBack, ()) {
  const auto word = rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::elementOf(std::string("abz-_09"))));
  Plan plan;
  for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
    plan.steps.push_back({*word, *rc::gen::container<std::vector<std::string>>(word)});
  }
  RC_ASSERT(parse_plan(to_string(plan), "x").steps == plan.steps);
}

class ValidatorTest : public testing::Test {
 protected:
  Domain domain_ = parse_domain(
      "(define (domain d) (:types t u) (:predicates (at ?x - t) (near ?x ?y - t)) (:action go :parameters (?a ?b - t)"
      " :precondition (and (at ?a) (not (= ?a ?b)) (not (near ?a ?b))) :effect (and (not (at ?a)) (at ?b))))",
      "d");
  Problem problem_ = parse_problem(
      "(define (problem p) (:domain d) (:objects x y z - t v - u) (:init (at x) (near x z))"
      " (:goal (at z)))",
      domain_, "p");
  [[nodiscard]] PlanFault fault(const std::string& text) const {
    return validate(domain_, problem_, parse_plan(text, "plan")).why();
  }
};

TEST_F(ValidatorTest, AcceptsAPlanAndTellsItsCost) {
  const auto cost = validate(domain_, problem_, parse_plan("(go x y)\n(go y z)", "plan"));
  ASSERT_TRUE(cost);
  EXPECT_EQ(*cost, 2);
}

TEST_F(ValidatorTest, NamesStepAndLiteral) {
  EXPECT_EQ(fault("(go x y)\n(go x z)").step, 2U);
  EXPECT_EQ(fault("(go x y)\n(go x z)").literal, "(at x)");
  EXPECT_EQ(fault("(go x z)").literal, "(not (near x z))");
  EXPECT_EQ(fault("(go x x)").literal, "(not (= x x))");
  EXPECT_EQ(fault("(go x y)").literal, "(at z)");
  EXPECT_FALSE(fault("(go x y)").step.has_value());
  EXPECT_EQ(fault("(fly x y)").step, 1U);
  EXPECT_NE(fault("(go x v)").sentence.find("wrong type"), std::string::npos);
  EXPECT_NE(fault("(go x)").sentence.find("takes 2 arguments"), std::string::npos);
  EXPECT_NE(fault("(go x nowhere)").sentence.find("no object 'nowhere'"), std::string::npos);
}

TEST(ProblemText, IsReadBackAndRefusesNamesThatPddlHasNot) {
  const Domain domain = parse_domain(
      "(define (domain d) (:types t) (:predicates (at ?x - t)) (:functions (total-cost)"
      " (far ?x - t)))",
      "d");
  ProblemText text{"p", "d", {{"a", "t"}}, {{"at", {"a"}}}, {{"far", {"a"}, 12.5}}, {{"at", {"a"}}}, true};
  const Problem problem = parse_problem(to_pddl(text), domain, "p");
  EXPECT_EQ(problem.init.size(), 1U);
  EXPECT_EQ(problem.values.at(0).value, 12.5);
  EXPECT_TRUE(problem.minimize_cost);
  text.objects[0].name = "a b";
  EXPECT_THROW((void)to_pddl(text), ArgumentError);
}

}  // namespace
}  // namespace amiss::plan
