#include "plan/domain.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/result.hpp"
#include "plan/problem.hpp"

namespace amiss::plan {
namespace {

std::string error_of(const std::string& text) {
  try {
    (void)parse_domain(text, "d.pddl");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string with_action(const std::string& rest) {
  return "(define (domain d)\n (:predicates (p ?x) (q) (clear ?x))\n (:action a :parameters (?x)\n" + rest + "))";
}

TEST(Domain, KeepsTypesAndTheirAncestors) {
  const Domain domain = parse_domain(
      "(DEFINE (DOMAIN D) (:types truck - vehicle vehicle place - object) (:predicates (at ?v - vehicle ?p - place))"
      " (:action go :parameters (?t - (either truck place)) :effect (and)))",
      "d.pddl");
  EXPECT_EQ(domain.name, "d");
  ASSERT_EQ(domain.types.size(), 4U);  // object, truck, vehicle, place
  EXPECT_TRUE(domain.types[1].is_a[2]);
  EXPECT_FALSE(domain.types[2].is_a[1]);
  EXPECT_TRUE(accepts(domain, domain.predicates[0].parameters[0], 1));
  EXPECT_FALSE(accepts(domain, domain.predicates[0].parameters[0], 3));
  EXPECT_TRUE(accepts(domain, domain.actions[0].parameters[0], 3));
}

TEST(Domain, ErrorsNameFileLineAndWhatIsAllowed) {
  EXPECT_EQ(error_of(with_action(" :precondition (claer ?x)")),
            "d.pddl:4: the predicate 'claer' is not declared; did you mean 'clear'?");
  EXPECT_EQ(error_of(with_action(" :precondition (p ?x ?x)")), "d.pddl:4: '(p ?x ?x)' has 2 arguments; 'p' takes 1");
  EXPECT_NE(error_of(with_action(" :effect (p ?y)")).find("d.pddl:4: the variable '?y' is not bound"),
            std::string::npos);
  EXPECT_NE(error_of("(define (domain d)\n (:requirements :strips :durative-actions))")
                .find("d.pddl:2: the requirement "
                      "':durative-actions' is not supported; allowed are :strips"),
            std::string::npos);
  EXPECT_NE(error_of("(define (domain d) (:types a - b b - a))").find("its own ancestor"), std::string::npos);
  EXPECT_NE(error_of("(define (domain d)\n\n (:predicates (p)").find("d.pddl:3: "), std::string::npos);
}

TEST(Domain, RefusesWhatIsNoDomain) {
  for (const std::string text : {"", ")", "(", "(define)", "(defie (domain d))", "(define (problem p))", "x", ";c\n",
                                 "(define (domain d)) more", "(define (domain d) (:derived (p) (q)))"}) {
    EXPECT_TRUE(error_of(text).starts_with("d.pddl:")) << text << ": " << error_of(text);
  }
  EXPECT_NE(error_of(std::string("(define \0 (domain d))", 21)).find("byte 0"), std::string::npos);
}

TEST(Domain, DeepNestingIsAnErrorNotACrash) {
  const std::string deep(2'000'000, '(');
  EXPECT_NE(error_of("(define (domain d) " + deep).find("nested deeper than 200"), std::string::npos);
}

RC_GTEST_PROP(Domain, AnyBytesEndWithADomainOrAnInputError, (const std::string& bytes)) {
  const std::string text = "(define (domain d) (:predicates (p)) " + bytes + ")";
  (void)error_of(bytes);
  (void)error_of(text);
}

TEST(Problem, ErrorsNameFileAndLine) {
  const Domain domain = parse_domain("(define (domain d) (:types t u) (:predicates (p ?x - t)))", "d.pddl");
  const auto error = [&](const std::string& text) -> std::string {
    try {
      (void)parse_problem(text, domain, "p.pddl");
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_NE(error("(define (problem x)\n(:domain other)\n(:goal (and)))").find("p.pddl:2: the problem is for"),
            std::string::npos);
  EXPECT_NE(error("(define (problem x) (:domain d)\n(:init (p a))\n(:goal (and)))").find("p.pddl:2: the object 'a'"),
            std::string::npos);
  EXPECT_NE(error("(define (problem x) (:domain d))").find("no (:goal"), std::string::npos);
  EXPECT_NE(error("(define (problem x) (:domain d) (:objects a - v) (:goal (and)))").find("the type 'v'"),
            std::string::npos);
  EXPECT_EQ(error("(define (problem x) (:domain d) (:objects a - t) (:init (p a)) (:goal (p a)))"), "no error");
}

}  // namespace
}  // namespace amiss::plan
