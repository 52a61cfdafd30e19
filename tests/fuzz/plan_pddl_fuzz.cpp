// libFuzzer target: any bytes as domain, problem and plan end with a value or an InputError, never with a crash.
#include <cstdint>
#include <string_view>

#include "core/result.hpp"
#include "plan/planner.hpp"
#include "plan/validator.hpp"

namespace {

constexpr std::string_view kDomain =
    "(define (domain d) (:types a b - c) (:constants k - a) (:predicates (p ?x - c) (q ?x ?y)) (:functions (total-cost)"
    " (f ?x)) (:action go :parameters (?x - a ?y) :precondition (or (p ?x) (not (q ?x ?y))) :effect (and (not (p ?x))"
    " (when (q ?y ?x) (p k)) (increase (total-cost) (f ?x)))))";
constexpr std::string_view kProblem =
    "(define (problem e) (:domain d) (:objects o - a u - b) (:init (p o) (= (f k) 2)) (:goal (q o u)))";

template <class Read>
void try_to(const Read& read) {
  try {
    read();
  } catch (const amiss::InputError&) {  // what bad input should end with
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amiss::plan;
  // A zero byte divides the input into domain, problem and plan; what is missing is taken from above.
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t first = text.find('\0');
  const std::string_view domain_text = text.substr(0, first);
  const std::string_view rest = first == std::string_view::npos ? kProblem : text.substr(first + 1);
  const std::size_t second = rest.find('\0');
  const std::string_view plan_text = second == std::string_view::npos ? "(go k k)" : rest.substr(second + 1);
  try_to([&] {
    const Domain domain = parse_domain(domain_text.empty() ? kDomain : domain_text, "domain");
    const Problem problem = parse_problem(rest.substr(0, second), domain, "problem");
    const auto solution =
        solve(domain, problem, {.max_ground_actions = 200, .max_evaluated_states = 200, .improvement_states = 5000});
    if (solution && !validate(domain, problem, solution->plan)) __builtin_trap();
  });
  try_to([&] {
    const Domain domain = parse_domain(kDomain, "domain");
    (void)validate(domain, parse_problem(kProblem, domain, "problem"), parse_plan(plan_text, "plan"));
  });
  return 0;
}
